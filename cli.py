"""graphkin from a clone: python cli.py draw ex3-1"""

from graphkin.cli import main

main()
