"""Problem sets: one mechanism, each student with numbers of their own.

    template.toml --template--> Template     a mechanism file with ranges
    Template + roster + seed --draws--> Variant for each student, posed well (`posed`)
    Variant --text, writing--> DIR/NAME.toml, DIR/NAME.txt, DIR/set.json
"""

from graphkin.problems.draws import Variant, variants
from graphkin.problems.posed import Posed, tellable, well_posed
from graphkin.problems.roster import Student, roster
from graphkin.problems.template import Range, Template, read_template
from graphkin.problems.text import remark, statement
from graphkin.problems.writing import write_set

__all__ = [
    "Posed", "Range", "Student", "Template", "Variant", "read_template", "remark", "roster", "statement", "tellable",
    "variants", "well_posed", "write_set",
]  # fmt: skip
