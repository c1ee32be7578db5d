"""Kernels straight from their text to LLVM: loops over lanes, without branches, of numbers only.

Numba infers the type of every operation and writes it down as a dozen instructions, which LLVM takes away again:
milliseconds for each of the thousands of operations of a machine. A kernel needs none of it. Its text is a few kinds
of statement about float64 and int64: assignments, ``for .. in range(..)``, ``+=`` and a ``return`` of one number;
arithmetic, comparisons, ``a if b else c``, numbers of one-dimensional arrays, sqrt, floor, abs, min, max, calls of
functions that are written likewise, which are put in their place, and the `PRIMITIVES`. What is decorated with
`straight` is translated when a function that Numba compiles calls it, once for each of those; anything else in its text
is an error.

Where the environment has ``DELTACAL_PLAIN_JIT=1``, `straight` is Numba's own ``njit``: the same kernels, compiled by
somebody else.
"""

from __future__ import annotations

import ast
import inspect
import math
import operator
import os
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from llvmlite import ir
from numba import njit, types
from numba.core import cgutils, errors
from numba.extending import intrinsic, overload

PLAIN = os.environ.get("DELTACAL_PLAIN_JIT") == "1"
DOUBLE, INTEGER, TRUTH = ir.DoubleType(), ir.IntType(64), ir.IntType(1)
CONTRACT = ("contract",)  # a product and a sum may become one operation
ARITHMETIC = {
    ast.Add: ("add", operator.add),
    ast.Sub: ("sub", operator.sub),
    ast.Mult: ("mul", operator.mul),
    ast.Div: ("div", operator.truediv),
}
SIGN = INTEGER(-(2**63))  # the bit of the sign
FRACTION = 52  # bits of a number behind its exponent
LOGIC = {ast.BitAnd: "and_", ast.BitOr: "or_"}
ORDER = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="}


def _odd(builder: Any, counted: Any) -> Any:
    last = builder.and_(builder.bitcast(counted, INTEGER), INTEGER(1))
    return builder.icmp_unsigned("!=", last, INTEGER(0))


def _flipped(builder: Any, value: Any, counted: Any) -> Any:
    sign = builder.and_(builder.shl(builder.bitcast(counted, INTEGER), INTEGER(62)), SIGN)
    return builder.bitcast(builder.xor(builder.bitcast(value, INTEGER), sign), DOUBLE)


def _power(builder: Any, counted: Any) -> Any:
    exponent = builder.shl(builder.bitcast(counted, INTEGER), INTEGER(FRACTION))
    return builder.bitcast(builder.add(exponent, builder.bitcast(DOUBLE(1.0), INTEGER)), DOUBLE)


def _exponent(builder: Any, value: Any) -> Any:
    biased = builder.lshr(builder.bitcast(value, INTEGER), INTEGER(FRACTION))
    return builder.bitcast(builder.or_(biased, builder.bitcast(DOUBLE(2.0**FRACTION), INTEGER)), DOUBLE)


def _fraction(builder: Any, value: Any) -> Any:
    bits = builder.and_(builder.bitcast(value, INTEGER), INTEGER(2**FRACTION - 1))
    return builder.bitcast(builder.or_(bits, builder.bitcast(DOUBLE(1.0), INTEGER)), DOUBLE)


PRIMITIVES: dict[str, Callable[..., Any]] = {
    "odd": _odd,
    "flipped": _flipped,
    "power": _power,
    "exponent": _exponent,
    "fraction": _fraction,
}


@intrinsic
def power(_context: Any, counted: Any) -> Any:
    """Return 2 to a whole number from -1022 to 1023, which stands in the last bits of another, 1.5 2^52 more."""
    return types.float64(types.float64), lambda _, builder, _signature, given: _power(builder, *given)


@intrinsic
def exponent(_context: Any, value: Any) -> Any:
    """Return 2^52 + 1023 + n for a number 2^n f, 1 <= f < 2, that is positive."""
    return types.float64(types.float64), lambda _, builder, _signature, given: _exponent(builder, *given)


@intrinsic
def fraction(_context: Any, value: Any) -> Any:
    """Return f for a number 2^n f, 1 <= f < 2, that is positive."""
    return types.float64(types.float64), lambda _, builder, _signature, given: _fraction(builder, *given)


@intrinsic
def odd(_context: Any, counted: Any) -> Any:
    """Tell whether a number that stands in the last bits of another, 1.5 2^52 more, is odd."""
    return types.boolean(types.float64), lambda _, builder, _signature, given: _odd(builder, *given)


@intrinsic
def flipped(_context: Any, value: Any, counted: Any) -> Any:
    """Return a value, its sign changed where half of a number, rounded down, is odd.

    The number stands in the last bits of another, 1.5 2^52 more.
    """
    return types.float64(types.float64, types.float64), lambda _, builder, _signature, given: _flipped(builder, *given)


@cache
def _definitions(path: str) -> dict[str, ast.FunctionDef]:
    """Return the functions of a module, by name."""
    body = ast.parse(Path(path).read_text(encoding="utf-8")).body
    return {node.name: node for node in body if isinstance(node, ast.FunctionDef)}


def _definition(function: Callable[..., Any]) -> ast.FunctionDef:
    return _definitions(function.__code__.co_filename)[function.__name__]


def check_layout(name: str, *kinds: Any) -> None:
    """Raise Numba's error for arrays that are not C-contiguous: kernels read numbers one after the other."""
    for kind in kinds:
        if isinstance(kind, types.Array) and kind.layout != "C":
            raise errors.TypingError(f"{name}: {kind} is not C-contiguous; np.ascontiguousarray makes a copy that is.")


def flat(values: Any) -> Any:
    """Return an array's numbers one after the other, as a kernel's text takes them; anything else as it is."""
    raise NotImplementedError("only what Numba compiles calls this")


@overload(flat)
def _flat(values: Any) -> Any:
    def numbers(values: Any) -> Any:
        return values.reshape(values.size)

    def itself(values: Any) -> Any:
        return values

    return numbers if isinstance(values, types.Array) else itself


def _by_numba(function: Callable[..., Any]) -> Any:
    """Return a kernel that Numba compiles, whose arrays may have any number of dimensions."""
    compiled = njit(error_model="numpy", fastmath=set(CONTRACT))
    names = list(inspect.signature(function).parameters)
    text = f"def called({', '.join(names)}):\n    return kernel({', '.join(f'flat({name})' for name in names)})\n"
    found: dict[str, Any] = {"kernel": compiled(function), "flat": flat}
    exec(text, found)
    return compiled(found["called"])


def straight(function: Callable[..., Any], wide: bool = True) -> Any:
    """Return a function for the use of compiled ones.

    Its arguments are C-contiguous arrays, which do not overlap, and integers. `wide` is for loops over many lanes: they
    use the widest registers, and stay a function of their own.
    """
    if PLAIN:
        return _by_numba(function)
    definition = _definition(function)
    returns = isinstance(definition.body[-1], ast.Return)

    def typed(_context: Any, *arguments: Any) -> Any:
        check_layout(function.__name__, *arguments)
        given = (types.int64 if isinstance(kind, types.Integer) else kind for kind in arguments)
        return (types.int64 if returns else types.none)(*given), written

    def written(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        values = [
            context.make_array(kind)(context, builder, value).data if isinstance(kind, types.Array) else value
            for kind, value in zip(signature.args, arguments, strict=True)
        ]
        name = f"{function.__module__}.{function.__qualname__}.{'.'.join(str(v.type) for v in values)}"
        module = builder.module
        called = module.globals.get(name) or _function(module, name, function, [v.type for v in values], returns, wide)
        result = builder.call(called, values)
        return result if returns else context.get_dummy_value()

    context = inspect.Parameter("_context", inspect.Parameter.POSITIONAL_ONLY)
    own = inspect.signature(function)
    vars(typed)["__signature__"] = own.replace(parameters=[context, *own.parameters.values()])
    typed.__name__ = typed.__qualname__ = function.__name__
    return intrinsic(typed)


def _function(
    module: Any, name: str, function: Callable[..., Any], kinds: Sequence[Any], returns: bool, wide: bool
) -> Any:
    """Return a kernel as a function of an LLVM module."""
    made = ir.Function(module, ir.FunctionType(INTEGER if returns else ir.VoidType(), kinds), name)
    made.linkage = "internal"
    made.attributes.add("nounwind")
    if wide:
        widen(made)
    for argument in made.args:
        if isinstance(argument.type, ir.PointerType):
            argument.add_attribute("noalias")
    builder = ir.IRBuilder(made.append_basic_block("entry"))
    result = _Writer(builder, function, made.args).run()
    if returns:
        builder.ret(result)
    else:
        builder.ret_void()
    return made


def widen(function: Any) -> None:
    """Let LLVM use the widest registers in a function of its module, and keep it a function of its own.

    It takes half of AVX-512 on some processors, which costs loops over lanes a third of their speed; and a loop that is
    inlined elsewhere would be optimised, slowly, once more.
    """
    function.attributes.add("noinline")
    set.add(function.attributes, '"prefer-vector-width"="512"')  # which llvmlite does not know by name


class _Writer:
    """Writes the text of one function; a name stands for a value of LLVM, a number of Python, or a tuple of them."""

    def __init__(self, builder: Any, function: Callable[..., Any], arguments: Sequence[Any]) -> None:
        self.builder, self.function, self.definition = builder, function, _definition(function)
        names = [a.arg for a in self.definition.args.args]
        self.names: dict[str, Any] = dict(zip(names, arguments, strict=True))
        changed = (node.target for node in ast.walk(self.definition) if isinstance(node, ast.AugAssign))
        self.changing = {target.id for target in changed if isinstance(target, ast.Name)}

    def run(self) -> Any:
        """Return what the function returns."""
        return self._block(self.definition.body)

    def _block(self, statements: Sequence[ast.stmt]) -> Any:
        for node in statements:
            match node:
                case ast.Return(value=ast.expr() as value):
                    return self._of(value)
                case ast.Expr(value=ast.Constant()):  # a docstring
                    pass
                case ast.Assign(targets=[target], value=value):
                    self._assign(target, self._of(value))
                case ast.AugAssign(target=target, op=op, value=value) if type(op) in ARITHMETIC:
                    self._assign(target, self._operation(op, self._of(target), self._of(value)))
                case ast.For(ast.Name(id=name), ast.Call(func=ast.Name(id="range"), args=bounds), body=body):
                    self._loop(name, [self._value(self._of(b), INTEGER) for b in bounds], body)
                case _:
                    raise self._error(node)
        return None

    def _loop(self, name: str, bounds: Sequence[Any], body: Sequence[ast.stmt]) -> None:
        """Write a loop; what it names ends with it, and what it changes is changed by ``+=``."""
        start, stop, *step = bounds if len(bounds) > 1 else [INTEGER(0), *bounds]
        if step:
            loop = cgutils.for_range_slice(self.builder, start, stop, step[0], inc=True)
        else:
            loop = cgutils.for_range(self.builder, stop, start)
        outside = self.names
        with loop as (index, _):
            self.names = outside | {name: index}
            for node in body:
                if isinstance(node, ast.Return):
                    raise self._error(node)
                self._block([node])
                if any(self.names[known] is not value for known, value in outside.items()):
                    raise self._error(node)
        self.names = outside

    def _assign(self, target: ast.expr, value: Any) -> None:
        match target:
            case ast.Tuple(elts=parts):
                for part, one in zip(parts, value, strict=True):
                    self._assign(part, one)
            case ast.Name(id=name) if name in self.changing:
                value = self._value(value)
                if name not in self.names:
                    self.names[name] = cgutils.alloca_once(self.builder, value.type)
                self.builder.store(self._value(value, self.names[name].type.pointee), self.names[name])
            case ast.Name(id=name):
                self.names[name] = value
            case ast.Subscript():
                place = self._place(target)
                self.builder.store(self._value(value, place.type.pointee), place)
            case _:
                raise self._error(target)

    def _of(self, node: ast.expr) -> Any:
        """Return what an expression stands for."""
        match node:
            case ast.Constant(value=bool() | int() | float() as value):
                return value
            case ast.Name(id=name):
                if name in self.changing:
                    return self.builder.load(self.names[name])
                return self.names[name] if name in self.names else self.function.__globals__[name]
            case ast.Attribute(value=ast.Name(id="math" | "np"), attr=name):
                return getattr(math, name)
            case ast.Tuple(elts=parts):
                return tuple(self._of(part) for part in parts)
            case ast.Subscript():
                return self.builder.load(self._place(node))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in ARITHMETIC or type(op) in LOGIC:
                return self._operation(op, self._of(left), self._of(right))
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self._minus(self._of(operand))
            case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in ORDER:
                return self._compared(ORDER[type(op)], self._of(left), self._of(right))
            case ast.IfExp(test=test, body=first, orelse=second):
                return self._chosen(self._of(test), self._of(first), self._of(second))
            case ast.Call(func=called, args=arguments):
                return self._call(node, called, [self._of(a) for a in arguments])
        raise self._error(node)

    def _call(self, node: ast.expr, called: ast.expr, arguments: Sequence[Any]) -> Any:
        match called:
            case ast.Attribute(value=ast.Name(id="math"), attr="sqrt"):
                return self._intrinsic("llvm.sqrt", *arguments)
            case ast.Attribute(value=ast.Name(id="np"), attr="floor"):
                return self._intrinsic("llvm.floor", *arguments)
            case ast.Name(id="abs"):
                return self._intrinsic("llvm.fabs", *arguments)
            case ast.Name(id="min"):
                first, second = arguments
                return self._chosen(self._compared("<", second, first), second, first)
            case ast.Name(id="max"):
                first, second = arguments
                return self._chosen(self._compared(">", second, first), second, first)
            case ast.Name(id=name) if name in PRIMITIVES:
                return PRIMITIVES[name](self.builder, *(self._value(a, DOUBLE) for a in arguments))
            case ast.Name(id=name) if hasattr(self.function.__globals__.get(name), "py_func"):
                return _Writer(self.builder, self.function.__globals__[name].py_func, arguments).run()
        raise self._error(node)

    def _intrinsic(self, name: str, value: Any) -> Any:
        value = self._value(value, DOUBLE)
        return self.builder.call(self.builder.module.declare_intrinsic(name, [DOUBLE]), [value])

    def _place(self, node: ast.Subscript) -> Any:
        array, index = self._of(node.value), self._value(self._of(node.slice), INTEGER)
        return self.builder.gep(array, [index], inbounds=True)

    def _value(self, value: Any, kind: Any = None) -> Any:
        """Return a value of LLVM, of a kind."""
        if not isinstance(value, ir.Value):
            kind = kind or (DOUBLE if isinstance(value, float) else INTEGER)
            return ir.Constant(kind, float(value) if kind == DOUBLE else int(value))
        if kind == DOUBLE and value.type != DOUBLE:
            return (self.builder.uitofp if value.type == TRUTH else self.builder.sitofp)(value, DOUBLE)
        if kind == INTEGER and value.type == TRUTH:
            return self.builder.zext(value, INTEGER)
        return value

    def _pair(self, left: Any, right: Any, real: bool = False) -> tuple[Any, Any]:
        """Return two values of one kind; with `real`, of numbers that are not integers."""
        plain = {float: DOUBLE, int: INTEGER, bool: INTEGER}
        kinds = [v.type if isinstance(v, ir.Value) else plain[type(v)] for v in (left, right)]
        kind = DOUBLE if real or DOUBLE in kinds else TRUTH if kinds == [TRUTH, TRUTH] else INTEGER
        return self._value(left, kind), self._value(right, kind)

    def _operation(self, op: ast.operator, left: Any, right: Any) -> Any:
        if type(op) in LOGIC:
            return getattr(self.builder, LOGIC[type(op)])(*self._pair(left, right))
        name, plain = ARITHMETIC[type(op)]
        if not isinstance(left, ir.Value) and not isinstance(right, ir.Value):
            return plain(left, right)
        left, right = self._pair(left, right, name == "div")
        if left.type == DOUBLE:
            return getattr(self.builder, f"f{name}")(left, right, flags=CONTRACT)
        return getattr(self.builder, name)(left, right, flags=("nsw",))

    def _minus(self, value: Any) -> Any:
        if not isinstance(value, ir.Value):
            return -value
        return self.builder.fneg(value, flags=CONTRACT) if value.type == DOUBLE else self.builder.neg(value)

    def _compared(self, order: str, left: Any, right: Any) -> Any:
        left, right = self._pair(left, right)
        if left.type != DOUBLE:
            return self.builder.icmp_signed(order, left, right)
        return (self.builder.fcmp_unordered if order == "!=" else self.builder.fcmp_ordered)(order, left, right)

    def _chosen(self, test: Any, first: Any, second: Any) -> Any:
        if isinstance(first, tuple):
            return tuple(self._chosen(test, *pair) for pair in zip(first, second, strict=True))
        return self.builder.select(test, *self._pair(first, second))

    def _error(self, node: Any) -> Exception:
        path = Path(self.function.__code__.co_filename)
        return errors.UnsupportedError(
            f"{path}, line {node.lineno}: a straight kernel cannot hold {ast.unparse(node)!r}"
        )
