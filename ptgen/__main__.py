"""``python -m ptgen``."""

from ptgen.cli import main

if __name__ == "__main__":
    main()
