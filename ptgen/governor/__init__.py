"""Reference governor: the closed loop it predicts, the limits it keeps, and the ways to shape references."""
