"""The commands, as `python -m graphkin`."""

from graphkin.cli import main

if __name__ == "__main__":  # processes of `--jobs` import this file, too
    main()
