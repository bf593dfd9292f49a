"""Problem sets: one mechanism, each student with numbers of their own.

    template.toml --template--> Template     a mechanism file with ranges
    Template + roster + seed --draws--> Variant for each student, in one assembly (`carried`), posed well (`posed`),
    and of several such the first in which mistakes can be told apart as well as the template can (`marking.told`)

say.problems words a problem; handouts writes the set for graphkin, platforms for others.
"""

from graphkin.homework.problems.carried import sketched_anew
from graphkin.homework.problems.draws import Variant, drawn_variants, roster
from graphkin.homework.problems.posed import PosedProblem, well_posed
from graphkin.homework.problems.template import Template, TemplateRange, read_template

__all__ = [
    "PosedProblem", "Template", "TemplateRange", "Variant", "drawn_variants", "read_template", "roster",
    "sketched_anew", "well_posed",
]  # fmt: skip
