r"""Mathematics for readers, in two languages at once: presentation MathML for pages, LaTeX for Markdown.

Every function here makes one node of a formula from its parts and keeps both texts in step, so that no report says
in one format what it does not say in the other. `expression` is a SymPy printer on top of these nodes.
"""

from __future__ import annotations

import html
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.printing.printer import Printer

_LETTERS = "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi pi rho sigma tau phi chi psi omega"
_GREEK = dict(zip(_LETTERS.split(" "), "αβγδεζηθκλμνξπρστφχψω", strict=True))
_FUNCTIONS = ("cos", "sin", "tan", "exp")


@dataclass(frozen=True)
class Math:
    """A formula as MathML and as LaTeX."""

    mathml: str
    latex: str

    def __add__(self, other: Math) -> Math:
        return Math(self.mathml + other.mathml, _joined(self.latex, other.latex))


def _joined(left: str, right: str) -> str:
    r"""Keep a command such as ``\cos`` apart from a letter behind it."""
    apart = re.search(r"\\[A-Za-z]+$", left) and right[:1].isalpha()
    return f"{left} {right}" if apart else left + right


Shown = Callable[[sp.Expr], Math | None]  # how a symbol or an applied function is shown; None: by its name
EMPTY = Math("", "")


def _group(body: Math) -> Math:
    return Math(f"<mrow>{body.mathml}</mrow>", f"{{{body.latex}}}")


def row(*parts: Math) -> Math:
    """Put parts one behind the other."""
    whole = EMPTY
    for part in parts:
        whole = whole + part
    return Math(f"<mrow>{whole.mathml}</mrow>", whole.latex)


_OPERATORS = {
    "−": "-",
    "·": r"\cdot ",
    "×": r"\times ",
    "∂": r"\partial ",
    "≡": r"\equiv ",
    "≈": r"\approx ",
    "∈": r"\in ",
    "⇒": r"\;\Rightarrow\; ",
    "∑": r"\sum ",
    "…": r"\ldots ",
    "⊤": r"\top ",
    "∧": r"\wedge ",
    "∨": r"\vee ",
    "→": r"\to ",
    "≤": r"\le ",
    "≥": r"\ge ",
    "≠": r"\ne ",
}


def op(sign: str) -> Math:
    """Return an operator or bracket."""
    form = ' form="prefix"' if sign == "∂" else ""
    return Math(f"<mo{form}>{html.escape(sign)}</mo>", _OPERATORS.get(sign, sign))


def gap() -> Math:
    """Return a wide space."""
    return Math('<mspace width="1em"/>', r"\quad ")


def thin() -> Math:
    """Return the space between the factors of a product."""
    return Math('<mspace width="0.17em"/>', r"\,")


def number(value: object) -> Math:
    """Return a number."""
    return Math(f"<mn>{value}</mn>", str(value))


def words(text: str) -> Math:
    """Return upright text."""
    return Math(f"<mtext>{html.escape(text)}</mtext>", rf"\text{{{text}}}".replace("_", r"\_"))


def letter(text: str, *, bold: bool = False) -> Math:
    """Return an identifier: a letter in italics, a word upright, a vector or matrix in bold."""
    shown = _GREEK.get(text, text)
    tex = rf"\{text}" if text in _GREEK else text
    if bold:
        return Math(f'<mi class="b">{shown}</mi>', rf"\boldsymbol{{{tex}}}" if text in _GREEK else rf"\mathbf{{{tex}}}")
    if text in _FUNCTIONS:
        return Math(f"<mi>{text}</mi>", rf"\{text} ")
    if len(shown) > 1:
        return Math(f"<mi>{html.escape(shown)}</mi>", rf"\mathrm{{{shown}}}".replace("_", r"\_"))
    if shown == "Δ":
        tex = r"\Delta"
    return Math(f"<mi>{shown}</mi>", tex)


def sub(base: Math, index: Math) -> Math:
    """Return a base with a subscript."""
    return Math(f"<msub>{_group(base).mathml}{_group(index).mathml}</msub>", f"{{{base.latex}}}_{{{index.latex}}}")


def sup(base: Math, exponent: Math) -> Math:
    """Return a base with a superscript."""
    shown = f"<msup>{_group(base).mathml}{_group(exponent).mathml}</msup>"
    return Math(shown, f"{{{base.latex}}}^{{{exponent.latex}}}")


def frac(above: Math, below: Math) -> Math:
    """Return a fraction."""
    return Math(
        f"<mfrac>{_group(above).mathml}{_group(below).mathml}</mfrac>", rf"\frac{{{above.latex}}}{{{below.latex}}}"
    )


def root(body: Math) -> Math:
    """Return a square root."""
    return Math(f"<msqrt>{body.mathml}</msqrt>", rf"\sqrt{{{body.latex}}}")


def brackets(body: Math, pair: str = "()") -> Math:
    """Return a body in brackets that grow with it."""
    left, right = pair[0], pair[1]
    tex = {"⌊": r"\lfloor ", "⌋": r"\rfloor "}
    form = {"|": (' form="prefix"', ' form="postfix"')}.get(left, ("", ""))
    return Math(
        f"<mrow><mo{form[0]}>{left}</mo>{body.mathml}<mo{form[1]}>{right}</mo></mrow>",
        rf"\left{tex.get(left, left)}{body.latex}\right{tex.get(right, right)}",
    )


def matrix(rows: Sequence[Sequence[Math]]) -> Math:
    """Return a matrix, or a column where each row has one entry."""
    cells = "".join("<mtr>" + "".join(f"<mtd>{_group(e).mathml}</mtd>" for e in entries) + "</mtr>" for entries in rows)
    tex = r" \\ ".join(" & ".join(e.latex for e in entries) for entries in rows)
    return Math(
        f"<mrow><mo>(</mo><mtable>{cells}</mtable><mo>)</mo></mrow>", rf"\begin{{pmatrix}} {tex} \end{{pmatrix}}"
    )


def cases(rows: Sequence[tuple[Math, Math]]) -> Math:
    """Return values, each with its condition."""
    cells = "".join(f"<mtr><mtd>{_group(e).mathml}</mtd><mtd>{_group(c).mathml}</mtd></mtr>" for e, c in rows)
    tex = r" \\ ".join(f"{e.latex} & {c.latex}" for e, c in rows)
    return Math(f"<mrow><mo>{{</mo><mtable>{cells}</mtable></mrow>", rf"\begin{{cases}} {tex} \end{{cases}}")


def separated(parts: Iterable[Math], by: str = ",") -> Math:
    """Return a list."""
    whole = EMPTY
    for n, part in enumerate(parts):
        whole = part if n == 0 else whole + op(by) + (Math("", r"\,") if by == "," else EMPTY) + part
    return whole


def equation(left: Math, *right: Math) -> Math:
    """Return ``left = right = ...``."""
    whole = left
    for side in right:
        whole = whole + op("=") + side
    return row(whole)


def name(text: str, *, bold: bool = False) -> Math:
    """Return a symbol by its name: Greek letters, indices after an underscore, a digit or at the end as an axis.

    ``alpha03`` has the index 03, ``px`` the index x, ``R1_11`` the indices 1 and then 11; a word stays a word.
    """
    if text.startswith("d") and len(text) > 1 and not bold and re.fullmatch(r"d[a-zA-Z](_mean)?", text):
        return row(letter("Δ"), name(text[1:]))
    if text in _GREEK or len(text) == 1:
        return letter(text, bold=bold)
    if re.fullmatch(r"[A-Z]{2,}(_[A-Z]+)+", text):  # a constant of a file
        return letter(text.lower().replace("_", " "), bold=bold)
    head, _, tail = text.partition("_")
    index = [tail] if tail else []
    found = re.fullmatch(r"([A-Za-z]+?)(\d+[xyz]?|[xyz])", head)
    if (found and (len(found[1]) == 1 or found[1] in _GREEK)) or (found := re.fullmatch(r"([a-z])([xyz]\d+)", head)):
        head, index = found[1], [found[2], *index]
    base = letter(head, bold=bold)
    if not index:
        return base
    marks = [m for part in index for m in part.split("_")]
    shown = separated((_mark(m) for m in marks), ",")
    return sub(base, shown)


def transposed(of: Math) -> Math:
    """Return a matrix transposed."""
    return sup(of, op("⊤"))


def vector(text: str) -> Math:
    """Return the name of a vector or matrix, bold.

    ``d x`` is its differential, ``∂r/∂q`` one's derivative by another, ``R⊤`` it transposed, ``r ×`` the matrix of the
    cross product with it, ``[r]`` the same written as a matrix.
    """
    if text.startswith("d "):
        return row(words("d"), vector(text[2:]))
    if found := re.fullmatch(r"∂(.+)/∂(.+)", text):
        return partial(vector(found[1]), vector(found[2]))
    if text.endswith("⊤"):
        return transposed(vector(text[:-1]))
    if text.endswith(" ×"):
        return row(vector(text[:-2]), op("×"))
    if text.startswith("["):
        return sub(brackets(vector(text[1:-1]), "[]"), op("×"))
    return name(text, bold=True)


def partial(of: Math, by: Math) -> Math:
    """Return a partial derivative."""
    return frac(row(op("∂"), of), row(op("∂"), by))


def _mark(text: str) -> Math:
    if text.isdigit():
        return number(text)
    axis = re.fullmatch(r"(\d+)([xyz])", text)
    if axis:
        return number(axis[1]) + letter(axis[2])
    axis = re.fullmatch(r"([xyz])(\d+)", text)
    return letter(axis[1]) + number(axis[2]) if axis else letter(text)


class _Expression(Printer):
    """SymPy expressions as formulas; symbols are looked up, or typeset by their names."""

    printmethod = "_typeset"

    def __init__(self, symbols: Shown) -> None:
        super().__init__()
        self._symbols = symbols

    def typeset(self, expr: sp.Expr) -> Math:
        made: Any = self._print(expr)
        return made if isinstance(made, Math) else words(str(made))

    # every method below is called by its name by SymPy's printer
    def _print_Symbol(self, expr: sp.Symbol) -> Math:
        return self._symbols(expr) or name(str(expr))

    def _print_Integer(self, expr: sp.Integer) -> Math:
        return number(abs(int(expr))) if expr >= 0 else row(op("−"), number(abs(int(expr))))

    def _print_Rational(self, expr: sp.Rational) -> Math:
        shown = frac(number(abs(expr.p)), number(expr.q))
        return shown if expr.p >= 0 else row(op("−"), shown)

    def _print_Float(self, expr: sp.Float) -> Math:
        return number(f"{float(expr):.6g}")

    def _print_Pi(self, expr: sp.Expr) -> Math:
        return letter("pi")

    def _print_Add(self, expr: sp.Add) -> Math:
        terms = sorted(expr.as_ordered_terms(), key=self._late)
        whole = EMPTY
        for n, term in enumerate(terms):
            negative = term.could_extract_minus_sign()
            shown = self.typeset(-term if negative else term)
            if (-term if negative else term).is_Add:
                shown = brackets(shown)
            whole = whole + (op("−") if negative else op("+") if n else EMPTY) + shown
        return row(whole)

    def _late(self, term: sp.Expr) -> tuple[bool, bool]:
        """Errors come behind what they are errors of, negative terms behind positive ones."""
        shown = [self._print_Symbol(s) for s in term.free_symbols]
        return term.could_extract_minus_sign(), any(
            m is not None and ("δ" in m.mathml or "Δ" in m.mathml) for m in shown
        )

    def _print_Mul(self, expr: sp.Mul) -> Math:
        if expr.could_extract_minus_sign() and expr.as_coeff_Mul()[0] < 0:
            rest = -expr
            return row(op("−"), brackets(self.typeset(rest)) if rest.is_Add else self.typeset(rest))
        above, below = sp.fraction(expr)
        if below != 1:
            coefficient = above.as_coeff_Mul()[0]
            if below.is_number and coefficient == 1 and (above.is_Add or isinstance(above, AppliedUndef)):
                return row(frac(number(1), self.typeset(below)), self._factor(above))
            return frac(self.typeset(above), self.typeset(below))
        whole, before = EMPTY, False
        for factor in _ordered_factors(expr):
            shown = self._factor(factor)
            if before and factor.is_number:
                whole = whole + op("·")
            elif before:
                whole = whole + (op("·") if _is_word(whole) or _is_word(shown) else thin())
            whole, before = whole + shown, True
        return row(whole)

    def _factor(self, expr: sp.Expr) -> Math:
        return brackets(self.typeset(expr)) if expr.is_Add else self.typeset(expr)

    def _print_Pow(self, expr: sp.Pow) -> Math:
        base, exponent = expr.as_base_exp()
        if exponent == sp.Rational(1, 2):
            return root(self.typeset(base))
        if exponent.is_negative:
            return frac(number(1), self.typeset(base ** (-exponent)))
        if isinstance(base, sp.sin | sp.cos | sp.tan):
            return row(sup(letter(type(base).__name__), self.typeset(exponent)), self._argument(base.args[0]))
        shown = self.typeset(base)
        return sup(shown if base.is_Symbol or base.is_Integer else brackets(shown), self.typeset(exponent))

    def _argument(self, expr: sp.Expr) -> Math:
        shown = self.typeset(expr)
        return row(thin(), shown) if expr.is_Symbol else brackets(shown)

    def _print_Function(self, expr: sp.Function) -> Math:
        found = self._symbols(expr)
        if found is not None:
            return found
        title = type(expr).__name__
        shown = letter(title)
        if len(expr.args) == 1:
            return row(shown, self._argument(expr.args[0]))
        return row(shown, brackets(separated(map(self.typeset, expr.args))))

    def _print_Abs(self, expr: sp.Abs) -> Math:
        return brackets(self.typeset(expr.args[0]), "||")

    def _print_sign(self, expr: sp.sign) -> Math:
        return row(letter("sgn"), brackets(self.typeset(expr.args[0])))

    def _print_Heaviside(self, expr: sp.Heaviside) -> Math:
        return row(letter("H"), brackets(self.typeset(expr.args[0])))

    def _print_floor(self, expr: sp.floor) -> Math:
        return brackets(self.typeset(expr.args[0]), "⌊⌋")

    def _print_Mod(self, expr: sp.Mod) -> Math:
        return row(self._factor(expr.args[0]), words(" mod "), self._factor(expr.args[1]))

    def _print_Max(self, expr: sp.Max) -> Math:
        return row(letter("max"), brackets(separated(map(self.typeset, expr.args))))

    def _print_Min(self, expr: sp.Min) -> Math:
        return row(letter("min"), brackets(separated(map(self.typeset, expr.args))))

    def _print_Piecewise(self, expr: sp.Piecewise) -> Math:
        return cases([(self.typeset(e), self.typeset(condition)) for e, condition in expr.args])

    def _print_Relational(self, expr: sp.Rel) -> Math:
        sign = {"<=": "≤", ">=": "≥", "!=": "≠", "==": "="}.get(expr.rel_op, expr.rel_op)
        return row(self.typeset(expr.lhs), op(sign), self.typeset(expr.rhs))

    def _print_BooleanTrue(self, expr: sp.Basic) -> Math:
        return words("otherwise")

    def _print_And(self, expr: sp.And) -> Math:
        return separated(map(self.typeset, expr.args), "∧")

    def _print_Or(self, expr: sp.Or) -> Math:
        return separated(map(self.typeset, expr.args), "∨")

    def _print_Derivative(self, expr: sp.Derivative) -> Math:
        of = letter(type(expr.expr).__name__) if isinstance(expr.expr, AppliedUndef) else self._factor(expr.expr)
        return partial(of, self.typeset(expr.variables[0]))

    def _print_Sum(self, expr: sp.Sum) -> Math:
        return row(sub(op("∑"), self.typeset(expr.limits[0][0])), self._factor(expr.function))

    # matrices and vectors by their names
    def _print_MatrixSymbol(self, expr: sp.MatrixSymbol) -> Math:
        return self._symbols(expr) or vector(expr.name)

    def _print_ImmutableDenseMatrix(self, expr: sp.ImmutableDenseMatrix) -> Math:
        if expr == sp.eye(expr.rows):
            return letter("I", bold=True)
        return matrix([[self.typeset(e) for e in expr.row(i)] for i in range(expr.rows)])

    def _print_ZeroMatrix(self, expr: sp.ZeroMatrix) -> Math:
        return number(0) if expr.shape == (1, 1) else letter("0", bold=True)

    def _print_Transpose(self, expr: sp.Transpose) -> Math:
        of = expr.arg
        if isinstance(of, sp.Inverse):
            return sup(self._raised(of.arg), row(op("−"), op("⊤")))
        return sup(self._raised(of), op("⊤"))

    def _print_MatPow(self, expr: sp.MatPow) -> Math:
        return sup(self._raised(expr.base), self.typeset(expr.exp))

    def _print_Inverse(self, expr: sp.Inverse) -> Math:
        of, transposed = expr.arg, isinstance(expr.arg, sp.Transpose)
        return sup(self._raised(of.arg if transposed else of), row(op("−"), op("⊤") if transposed else number(1)))

    def _raised(self, expr: sp.MatrixExpr) -> Math:
        shown = self.typeset(expr)
        return brackets(shown) if not isinstance(expr, sp.MatrixSymbol) or "∂" in expr.name else shown

    def _factor_of_matrices(self, expr: sp.MatrixExpr) -> Math:
        return brackets(self.typeset(expr)) if isinstance(expr, sp.MatAdd) else self.typeset(expr)

    def _print_MatMul(self, expr: sp.MatMul) -> Math:
        factor, matrices = expr.as_coeff_matrices()
        if factor.could_extract_minus_sign():
            return row(op("−"), self.typeset(sp.MatMul(-factor, *matrices)))
        above, below = sp.fraction(factor)
        whole = EMPTY
        for n, one in enumerate(matrices):
            alone = len(matrices) == 1 and not below.is_number
            whole = whole + (thin() if n else EMPTY) + (self.typeset(one) if alone else self._factor_of_matrices(one))
        if not below.is_number and above == 1:
            return row(frac(whole, self.typeset(below)))
        return row(whole) if factor == 1 else row(self._factor(factor), whole)

    def _print_MatAdd(self, expr: sp.MatAdd) -> Math:
        whole = EMPTY
        for n, term in enumerate(sorted(expr.args, key=_degree)):
            negative = term.as_coeff_mmul()[0].could_extract_minus_sign()
            shown = self.typeset(-term if negative else term)
            whole = whole + (op("−") if negative else op("+") if n else EMPTY) + shown
        return row(whole)


def _degree(term: sp.MatrixExpr) -> tuple[bool, int]:
    """Return by what the terms of a sum of matrices are ordered: negative ones last, higher powers later."""
    factor, product = term.as_coeff_mmul()
    if isinstance(term, sp.MatrixBase):  # entries: the unit matrix
        return False, 0
    return factor.could_extract_minus_sign(), max([1, *(int(f.exp) for f in product.atoms(sp.MatPow))])


def _is_word(shown: Math) -> bool:
    """Return whether a product ends with a name of several letters, beside which a space says too little."""
    return re.search(r"\\mathrm\{[^{}]*\}(\}_\{[^{}]*(\{[^{}]*\})?[^{}]*\})?$", shown.latex) is not None


def _ordered_factors(expr: sp.Mul) -> list[sp.Expr]:
    """Return the factors as a human writes them: numbers, symbols, powers and roots, sums, functions."""

    def rank(factor: sp.Expr) -> int:
        base = factor.as_base_exp()[0]
        if factor.is_number:
            return 0
        if str(factor).startswith("d "):  # a differential
            return 9
        if base.is_Symbol:
            return 1
        return 2 if base.is_Add else 3

    return sorted(expr.as_ordered_factors(), key=rank)


def expression(expr: sp.Expr, symbols: Shown = lambda s: None) -> Math:
    """Return a SymPy expression as a formula; `symbols` may typeset symbols and applied functions its own way."""
    return _Expression(symbols).typeset(sp.sympify(expr))
