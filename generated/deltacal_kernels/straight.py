"""Kernels straight from their text to LLVM: loops over lanes, without branches, of numbers only.

Written by "deltacal kernels". Do not edit.

Numba infers the type of every operation and writes it down as a dozen instructions, which LLVM takes away again:
milliseconds for each of the thousands of operations of a machine. A kernel needs none of it. Its text is a few kinds
of statement about float64 and int64: assignments, ``for .. in range(..)``, ``+=`` and a ``return`` of one number;
arithmetic, comparisons, ``a if b else c``, numbers of one-dimensional arrays, sqrt, abs, min, max, and calls of
functions that are written likewise, which are put in their place; and `odd` and `flipped`. What is decorated with `straight` is translated when
a function that Numba compiles calls it, once for each of those; anything else in its text is an error.
"""

import ast
import inspect
import math
import operator
from functools import cache
from pathlib import Path

from llvmlite import ir
from numba import types
from numba.core import cgutils, errors
from numba.extending import intrinsic

DOUBLE, INTEGER, TRUTH = ir.DoubleType(), ir.IntType(64), ir.IntType(1)
CONTRACT = ("contract",)  # a product and a sum may become one operation
ARITHMETIC = {
    ast.Add: ("add", operator.add),
    ast.Sub: ("sub", operator.sub),
    ast.Mult: ("mul", operator.mul),
    ast.Div: ("div", operator.truediv),
}
SIGN = INTEGER(-(2**63))  # the bit of the sign
LOGIC = {ast.BitAnd: "and_", ast.BitOr: "or_"}
ORDER = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="}


def _odd(builder, counted):
    last = builder.and_(builder.bitcast(counted, INTEGER), INTEGER(1))
    return builder.icmp_unsigned("!=", last, INTEGER(0))


def _flipped(builder, value, counted):
    sign = builder.and_(builder.shl(builder.bitcast(counted, INTEGER), INTEGER(62)), SIGN)
    return builder.bitcast(builder.xor(builder.bitcast(value, INTEGER), sign), DOUBLE)


PRIMITIVES = {"odd": _odd, "flipped": _flipped}


@intrinsic
def odd(_context, counted):
    """Tell whether a number that stands in the last bits of another, 1.5 2^52 more, is odd."""
    return types.boolean(types.float64), lambda _, builder, _signature, given: _odd(builder, *given)


@intrinsic
def flipped(_context, value, counted):
    """Return a value, its sign changed where half of a number that stands in the last bits of another, rounded down, is odd."""
    return types.float64(types.float64, types.float64), lambda _, builder, _signature, given: _flipped(builder, *given)


@cache
def _definitions(path):
    """Return the functions of a module, by name."""
    body = ast.parse(Path(path).read_text(encoding="utf-8")).body
    return {node.name: node for node in body if isinstance(node, ast.FunctionDef)}


def _definition(function):
    return _definitions(function.__code__.co_filename)[function.__name__]


def check_layout(name, *kinds):
    """Raise Numba's error for arrays that are not C-contiguous: kernels read numbers one after the other."""
    for kind in kinds:
        if isinstance(kind, types.Array) and kind.layout != "C":
            raise errors.TypingError(f"{name}: {kind} is not C-contiguous; np.ascontiguousarray makes a copy that is.")


def straight(function, wide=True):
    """Return a function for the use of compiled ones; its arguments are C-contiguous arrays, which do not overlap, and integers.

    `wide` is for loops over many lanes: they use the widest registers, and stay a function of their own.
    """
    definition = _definition(function)
    returns = isinstance(definition.body[-1], ast.Return)

    def typed(_context, *arguments):
        check_layout(function.__name__, *arguments)
        given = (types.int64 if isinstance(kind, types.Integer) else kind for kind in arguments)
        return (types.int64 if returns else types.none)(*given), written

    def written(context, builder, signature, arguments):
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
    typed.__signature__ = own.replace(parameters=[context, *own.parameters.values()])
    typed.__name__ = typed.__qualname__ = function.__name__
    return intrinsic(typed)


def _function(module, name, function, kinds, returns, wide):
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


def widen(function):
    """Let LLVM use the widest registers in a function of its module, and keep it a function of its own.

    It takes half of AVX-512 on some processors, which costs loops over lanes a third of their speed; and a loop that is
    inlined elsewhere would be optimised, slowly, once more.
    """
    function.attributes.add("noinline")
    set.add(function.attributes, '"prefer-vector-width"="512"')  # which llvmlite does not know by name


class _Writer:
    """Writes the text of one function; a name stands for a value of LLVM, a number of Python, or a tuple of them."""

    def __init__(self, builder, function, arguments):
        self.builder, self.function, self.definition = builder, function, _definition(function)
        names = [a.arg for a in self.definition.args.args]
        self.names = dict(zip(names, arguments, strict=True))
        changing = (n for n in ast.walk(self.definition) if isinstance(n, ast.AugAssign) and isinstance(n.target, ast.Name))
        self.changing = {node.target.id for node in changing}

    def run(self):
        """Return what the function returns."""
        return self._block(self.definition.body)

    def _block(self, statements):
        for node in statements:
            match node:
                case ast.Return(value=value):
                    return self._of(value)
                case ast.Expr(value=ast.Constant()):  # a docstring
                    pass
                case ast.Assign(targets=[target], value=value):
                    self._assign(target, self._of(value))
                case ast.AugAssign(target=target, op=op, value=value) if type(op) in ARITHMETIC:
                    self._assign(target, self._operation(op, self._of(target), self._of(value)))
                case ast.For(target=ast.Name(id=name), iter=ast.Call(func=ast.Name(id="range"), args=bounds), body=body):
                    self._loop(name, [self._value(self._of(b), INTEGER) for b in bounds], body)
                case _:
                    raise self._error(node)
        return None

    def _loop(self, name, bounds, body):
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

    def _assign(self, target, value):
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

    def _of(self, node):
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

    def _call(self, node, called, arguments):
        match called:
            case ast.Attribute(value=ast.Name(id="math"), attr="sqrt"):
                return self._intrinsic("llvm.sqrt", *arguments)
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

    def _intrinsic(self, name, value):
        value = self._value(value, DOUBLE)
        return self.builder.call(self.builder.module.declare_intrinsic(name, [DOUBLE]), [value])

    def _place(self, node):
        array, index = self._of(node.value), self._value(self._of(node.slice), INTEGER)
        return self.builder.gep(array, [index], inbounds=True)

    def _value(self, value, kind=None):
        """Return a value of LLVM, of a kind."""
        if not isinstance(value, ir.Value):
            kind = kind or (DOUBLE if isinstance(value, float) else INTEGER)
            return ir.Constant(kind, float(value) if kind == DOUBLE else int(value))
        if kind == DOUBLE and value.type != DOUBLE:
            return (self.builder.uitofp if value.type == TRUTH else self.builder.sitofp)(value, DOUBLE)
        if kind == INTEGER and value.type == TRUTH:
            return self.builder.zext(value, INTEGER)
        return value

    def _pair(self, left, right, real=False):
        """Return two values of one kind; with `real`, of numbers that are not integers."""
        kinds = [v.type if isinstance(v, ir.Value) else DOUBLE if isinstance(v, float) else INTEGER for v in (left, right)]
        kind = DOUBLE if real or DOUBLE in kinds else TRUTH if kinds == [TRUTH, TRUTH] else INTEGER
        return self._value(left, kind), self._value(right, kind)

    def _operation(self, op, left, right):
        if type(op) in LOGIC:
            return getattr(self.builder, LOGIC[type(op)])(*self._pair(left, right))
        name, plain = ARITHMETIC[type(op)]
        if not isinstance(left, ir.Value) and not isinstance(right, ir.Value):
            return plain(left, right)
        left, right = self._pair(left, right, name == "div")
        if left.type == DOUBLE:
            return getattr(self.builder, f"f{name}")(left, right, flags=CONTRACT)
        return getattr(self.builder, name)(left, right, flags=("nsw",))

    def _minus(self, value):
        if not isinstance(value, ir.Value):
            return -value
        return self.builder.fneg(value, flags=CONTRACT) if value.type == DOUBLE else self.builder.neg(value)

    def _compared(self, order, left, right):
        left, right = self._pair(left, right)
        if left.type != DOUBLE:
            return self.builder.icmp_signed(order, left, right)
        return (self.builder.fcmp_unordered if order == "!=" else self.builder.fcmp_ordered)(order, left, right)

    def _chosen(self, test, first, second):
        if isinstance(first, tuple):
            return tuple(self._chosen(test, *pair) for pair in zip(first, second, strict=True))
        return self.builder.select(test, *self._pair(first, second))

    def _error(self, node):
        path = Path(self.function.__code__.co_filename)
        return NotImplementedError(f"{path}, line {node.lineno}: a straight kernel cannot hold {ast.unparse(node)!r}")
