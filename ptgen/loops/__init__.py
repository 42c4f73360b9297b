"""What is asked of the sampled closed loop of a bed: its analysis and its tuning."""
