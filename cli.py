"""graphkin from a clone: python cli.py draw ex3-1"""

from graphkin.cli import main

if __name__ == "__main__":  # processes of `--jobs` import this file, too
    main()
