"""How sentences of the solution are set: what is a sign in italics with its subscript, and where a sign ends."""

from __future__ import annotations

import pytest

from graphkin.sheet.lettering import formula


def _set(text: str) -> str:
    """In `*..*` what is in italics, in `[..]` what is low."""
    runs = ((f"*{run.text}*" if run.italic else run.text, run.place) for run in formula(text))
    return "".join(f"[{text}]" if place == "sub" else text for text, place in runs).replace("**", "")


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("位移 s_ram）上的 E 点", "位移 *s*[*ram*]）上的 *E* 点"),
        ("v_K4 = v_K1. So k1 serves", "*v*[*K*][4] = *v*[*K*][1]. So *k*[1] serves"),
        ("v_C = μ_v·pc", "*v*[*C*] = *μ*[*v*]·*pc*"),
        ("μ_v·bc/(μ_l·BC)", "*μ*[*v*]·*bc*/(*μ*[*l*]·*BC*)"),
        ("Measured: pe = 70.49 mm", "Measured: *pe* = 70.49 mm"),
        ("dc = db3 × CD/BD = 71.87 mm", "*dc* = *db*[3] × *CD*/*BD* = 71.87 mm"),
        ("pp1 = pm_sun × KP1/KM", "*pp*[1] = *pm*[*sun*] × *KP*[1]/*KM*"),
        ("(A above O2B); clockwise: oa, carried to A", "(*A* above *O*[2]*B*); clockwise: *oa*, carried to *A*"),
        ("L 在 CK 线上，故 l2 在线段 cp 上", "*L* 在 *CK* 线上，故 *l*[2] 在线段 *cp* 上"),
        ("△ek1d is similar to △EKD, both", "∆*ek*[1]*d* is similar to ∆*EKD*, both"),
        ("△o k_rack a ∽ △OKA", "∆*o* *k*[*rack*] *a* ∽ ∆*OKA*"),
        ("△o k_rack a is similar, as a point is", "∆*o* *k*[*rack*] *a* is similar, as a point is"),
        ("∆sk11f ∽ ∆SKF", "∆*sk*[11]*f* ∽ ∆*SKF*"),
        ("∆z2′ a1′ u1_3′ ∽ ∆Z2A1U1", "∆*z*[2]′ *a*[1]′ *u*[1,3]′ ∽ ∆*Z*[2]*A*[1]*U*[1]"),
        ("P′Q, ray P′P, lines B1B2′", "*P*′*Q*, ray *P*′*P*, lines *B*[1]*B*[2]′"),
        ("Through C draw Cm and Cn; ∠mCn", "Through *C* draw *Cm* and *Cn*; ∠*mCn*"),
        ("（ρ = v²/aⁿ），5 m/s²、3 mm²", "（*ρ* = *v*²/*an*），5 m/s²、3 mm²"),
        ("25.4 mm = 1 in", "25.4 mm = 1 in"),
        ("v_E′ = v_C′ + v_E′C′, e_E′", "*v*[*E*][′] = *v*[*C*][′] + *v*[*E*][′][*C*][′], *e*[*E*][′]"),
        ("n_OA′ and n_lever′", "*n*[*OA*]′ and *n*[*lever*]′"),
        ("由 p 作矢量 ⊥DE，得 w。", "由 *p* 作矢量 ⊥*DE*，得 *w*。"),
        ("so a and d4 lie on p", "so *a* and *d*[4] lie on *p*"),
        ("From A draw a line: e = 15 mm, n = 100 r/min", "From *A* draw a line: *e* = 15 mm, *n* = 100 r/min"),
        ("（即 r_r2→f_r2）平移，作 d r_r2 = v_F", "（即 *r*[*r*][2]→*f*[*r*][2]）平移，作 *d* *r*[*r*][2] = *v*[*F*]"),
        ("△a c_r1 d ∽ △ACD, 3 d later", "∆*a* *c*[*r*][1] *d* ∽ ∆*ACD*, 3 d later"),
        ("A line; A is not on (b), 3 h", "A line; *A* is not on (b), 3 h"),
    ],
)
def test_signs_end_where_their_words_go_on(text, wanted):
    assert _set(text) == wanted
