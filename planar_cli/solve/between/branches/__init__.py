"""Which of the branches of a motion happens, and what it comes to over its spans."""
