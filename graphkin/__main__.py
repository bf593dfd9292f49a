"""The commands, as `python -m graphkin`, as `graphkin`, and of a clone as `python cli.py`."""

import gc
import os

_BROKEN_OFF = 130  # the exit status after Ctrl-C, as shells have it


def run() -> None:
    """Start the commands; whoever breaks off while they are being loaded gets no traceback."""
    gc.set_threshold(200_000)  # it ends soon, and garbage need not be looked for while modules are loaded
    try:
        from graphkin.cli import main

        main()
    except KeyboardInterrupt:
        os._exit(_BROKEN_OFF)


if __name__ == "__main__":  # processes of `--jobs` import this file, too
    run()
