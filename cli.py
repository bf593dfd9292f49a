"""graphkin from a clone: python cli.py draw ex3-1"""

from graphkin.__main__ import run

if __name__ == "__main__":  # processes of `--jobs` import this file, too
    run()
