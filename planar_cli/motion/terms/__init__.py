"""Numbers that vary, as terms and as generated code, and the linear algebra on them."""
