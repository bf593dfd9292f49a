"""One design of each kind, made once for all that look at them."""

import math

from graphkin.studies.design import angle_pairs, coupler_positions, guide_bar, hinges, rocker, slider

rad = math.radians
DESIGNS = {
    "rocker": rocker(0.080, rad(40), 1.3, frame=0.071),
    "rocker free": rocker(0.080, rad(40), 1.3),
    "rocker by crank": rocker(0.080, rad(40), 1.3, crank=0.02),
    "rocker by coupler": rocker(0.080, rad(40), 1.3, coupler=0.09),
    "rocker by AC1": rocker(0.080, rad(40), 1.3, ac1=0.11),
    "rocker by gamma": rocker(0.080, rad(40), 1.3, gamma_min=rad(35)),
    "slider": slider(0.040, 1.2, offset=0.015),
    "slider below": slider(0.040, 1.2, offset=-0.015),
    "slider by rod": slider(0.040, 1.2, rod=0.05),
    "guide bar": guide_bar(1.5, frame=0.1),
    "guide bar by crank": guide_bar(1.5, crank=0.03),
    "two positions": coupler_positions(hinges([0.02j, 0.03 + 0.03j], [0.2, 0.9], 0.05)),
    "three positions": coupler_positions(hinges([0.02j, 0.01 + 0.025j, 0.025 + 0.022j], [0.2, 0.1, -0.2], 0.05)),
    "pairs": angle_pairs([(rad(p), rad(q)) for p, q in ((40, 60), (70, 75), (110, 100))], 0.1),
    "inversion": angle_pairs([(rad(p), rad(q)) for p, q in ((40, 60), (70, 75), (110, 100))], 0.1, crank=0.03),
}
