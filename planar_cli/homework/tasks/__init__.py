"""Many tasks on all cores, each within its limits, and their results on disk."""
