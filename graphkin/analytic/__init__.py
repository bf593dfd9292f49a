"""The analytic road: closed vector loops and the matrix method. It never reads a construction.

```
Mechanism -> rules      each pair's joints and linear relations (one function a kind, `RULES`)
          -> loops      a tree of joints places every link, each joint left over closes a loop
          -> newton     loops with the relations put in; Newton for many positions at once
          -> assembly   the drawn position: the assembly nearest to the sketch
          -> moving     from there to other driver values, the assembly kept by moving on
          -> rates      A y' = B, A y'' = -A' y' + B'
          -> motions    everything by name: Motion
          -> freedom    degrees of freedom by rank: Mobility
```
"""

from graphkin.analytic.freedom import Mobility, mobility
from graphkin.analytic.motions import Motion, motion
from graphkin.errors import NoAssembly, NotJoined, SingularPosition

__all__ = ["Mobility", "Motion", "NoAssembly", "NotJoined", "SingularPosition", "mobility", "motion"]
