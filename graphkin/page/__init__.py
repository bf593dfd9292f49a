"""Pages for the browser: a mechanism that is played with, and a drawing board; each one file that asks for nothing.

`writer` joins scripts, styles, words and data to a page. `tracks` follows the marks of a sheet along the drivers, and
`player` composes the page of a lecture from them. Nothing is computed in the browser but places between knots.
"""
