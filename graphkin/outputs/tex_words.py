"""Words and labels as LaTeX sets them: letters in italics, subscripts, and parts above these."""

from __future__ import annotations

from graphkin.sheet.lettering import Label, Run

_SIGNS = {
    "μ": r"$\mu$", "ω": r"$\omega$", "α": r"$\alpha$", "θ": r"$\theta$", "φ": r"$\varphi$", "ψ": r"$\psi$",
    "γ": r"$\gamma$", "β": r"$\beta$", "δ": r"$\delta$", "π": r"$\pi$", "±": r"$\pm$", "<": "$<$", ">": "$>$",
    "|": "$|$", "°": r"$^\circ$", "·": r"$\cdot$", "→": r"$\to$", "×": r"$\times$", "²": r"$^2$", "³": r"$^3$",
    "′": r"$'$", "″": r"$''$", "−": r"$-$", "⊥": r"$\perp$", "∥": r"$\parallel$", "∠": r"$\angle$", "√": r"$\surd$",
    "△": r"$\triangle$", "∽": r"$\sim$", "ṡ": r"$\dot{s}$", "\0": r"$\ddot{s}$",
    "\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
} | {sign: f"\\{sign}" for sign in "#$%&_{}"}  # fmt: skip


def tex_text(text: str) -> str:
    """Words with everything special escaped."""
    return "".join(_SIGNS.get(letter, letter) for letter in text.replace("s\u0308", "\0"))


def tex_words(label: Label) -> str:
    """Runs in text style; a part stands above the subscript it goes with."""
    text, low = "", ""
    for run in label:
        letters = _run(run)
        if run.place == "sub":
            low += letters
        elif run.place == "sup":
            text, low = text + _scripts(letters, low), ""
        else:
            text, low = text + _scripts("", low) + letters, ""
    return text + _scripts("", low)


def _run(run: Run) -> str:
    letters = tex_text(run.text)
    return rf"\textit{{{letters}}}" if run.italic else letters


def _scripts(high: str, low: str) -> str:
    if not high and not low:
        return ""
    return "$" + (rf"^{{\text{{{high}}}}}" if high else "") + (rf"_{{\text{{{low}}}}}" if low else "") + "$"
