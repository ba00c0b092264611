"""What is asked: of states of a motion, in closed form, and how an answer is put."""
