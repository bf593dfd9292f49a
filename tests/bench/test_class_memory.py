"""How much memory a class takes: records go through as they come, results are held until all is written."""

from __future__ import annotations

import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

VALUES = ("-3.92,62,2.5", "-5.65,68.7,3.62", "-3.7,,2.6", "-3.75,60,", "3.92,12.5,0")
SHORT, LONG = 500, 1_500
OWN_BYTES = {"json": 2_000, "files": 12_000}
"""Of a student; where results are written a record and a result."""
PROGRAM = """
import sys
from pathlib import Path
from graphkin.cli import main
try:
    main.main(sys.argv[2:], standalone_mode=False)
finally:
    status = Path("/proc/self/status").read_text()
    Path(sys.argv[1]).write_text(next(line.split()[1] for line in status.splitlines() if line.startswith("VmHWM")))
"""


def csv_class(path: Path, count: int) -> Path:
    rows = (f"s{k},{VALUES[k % 5]}\n" for k in range(count))
    path.write_text("student,omega 3,alpha 3,a_k B3B2\n" + "".join(rows))
    return path


def zip_class(path: Path, count: int) -> Path:
    with zipfile.ZipFile(path, "w") as archive:
        for k in range(count):
            pairs = zip(("omega 3", "alpha 3", "a_k B3B2"), VALUES[k % 5].split(","), strict=True)
            text = "[answers]\n" + "".join(f'"{name}" = {value}\n' for name, value in pairs if value)
            archive.writestr(f"First Last{k}_{k}_assignsubmission_file_/answers.toml", text)
    return path


CLASSES = {"csv": csv_class, "zip": zip_class}


@pytest.mark.bench
@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="no place to read the peak of memory from")
@pytest.mark.parametrize(("kind", "way"), [("csv", "json"), ("zip", "files")])
def test_memory_of_a_class(kind: str, way: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    short, long = (peak_mib(CLASSES[kind](tmp_path / f"{count}.{kind}", count), way) for count in (SHORT, LONG))
    student = (long - short) * 2**20 / (LONG - SHORT)
    with capsys.disabled():
        print(f"\n{kind}, {way}: peak {short:.0f} MiB for {SHORT}, {long:.0f} MiB for {LONG}: {long / short:.2f} times")
    assert student < OWN_BYTES[way]


def peak_mib(path: Path, way: str) -> float:
    """The most memory that marking a class takes."""
    peak = path.with_suffix(".peak")
    words = ["--json"] if way == "json" else ["-o", str(path.with_suffix(".out")), "--format", "csv", "--format", "report"]
    subprocess.run([sys.executable, "-c", PROGRAM, str(peak), "grade", "ex3-1", str(path), *words], check=True, stdout=subprocess.DEVNULL)
    return int(peak.read_text()) / 2**10
