"""ptgen: from one file that describes a power train test bed to model, controller and C code."""

__version__ = "0.1.0"
