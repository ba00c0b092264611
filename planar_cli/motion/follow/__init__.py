"""A motion followed through its changes of mode, its impacts and its states."""
