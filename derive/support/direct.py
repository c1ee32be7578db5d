"""A compiled command as a function of Python's own: numbers in, numbers out.

Numba asks the type of every argument, and unpacks an array anew in every call: longer than a command takes. Here the
command is called as Python calls what is built in, its numbers read where they are, the machine's state known.
"""

from __future__ import annotations

import ctypes
import inspect
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

from llvmlite import binding, ir
from numba import typeof, types
from numba.core import cgutils
from numba.core.compiler_lock import global_compiler_lock
from numba.core.registry import cpu_target
from numba.np.arrayobj import populate_array

OBJECT, COUNT = cgutils.voidptr_t, ir.IntType(8 * ctypes.sizeof(ctypes.c_ssize_t))
NUMBERS_IN_A_ROW = 0x80  # METH_FASTCALL


class _Method(ctypes.Structure):
    """What Python knows of a function that is built in (PyMethodDef)."""

    _fields_ = (("name", ctypes.c_char_p), ("code", ctypes.c_void_p), ("flags", ctypes.c_int), ("doc", ctypes.c_char_p))


def direct(command: Any, state: Any) -> Callable[..., Any]:
    """Return a function of all arguments of a compiled command but its last, which is `state` from now on.

    Its arguments are numbers, by position, and TypeError is raised for anything else; it returns what the command does.
    """
    method, library = _method(command, typeof(state), state.size)
    make = ctypes.pythonapi.PyCFunction_NewEx
    make.restype, make.argtypes = ctypes.py_object, (ctypes.c_void_p, ctypes.py_object, ctypes.c_void_p)
    own = (state, method, library)  # lives as long as the function, which reads the state
    return make(ctypes.addressof(method), own, None)


@global_compiler_lock
@cache
def _method(command: Any, kind: Any, size: int) -> tuple[_Method, Any]:
    """Return a command as Python calls it, whatever the state: LLVM keeps its code as long as the process lives."""
    names = list(inspect.signature(command.py_func).parameters)[:-1]
    kinds = (*[types.float64] * len(names), kind)
    command.compile(kinds)
    library, code = _function(command.overloads[kinds], names, size)
    what, _, _ = (inspect.getdoc(command.py_func) or "").partition("\n\n")  # further on it tells of the state
    told = f"{command.py_func.__name__}({', '.join(names)}, /)\n--\n\n{what}"
    return _Method(command.py_func.__name__.encode(), code, NUMBERS_IN_A_ROW, told.encode()), library


def _function(compiled: Any, names: Sequence[str], size: int) -> tuple[Any, int]:
    """Return a library, and in it the address of a function that Python calls."""
    context, signature = cpu_target.target_context, compiled.signature
    symbol = compiled.fndesc.llvm_func_name
    binding.add_symbol(symbol, compiled.library.get_pointer_to_function(symbol))
    library = context.codegen().create_library("direct")
    module = library.create_ir_module("direct")
    function = ir.Function(module, ir.FunctionType(OBJECT, [OBJECT, OBJECT.as_pointer(), COUNT]), f"direct_{symbol}")
    builder = ir.IRBuilder(function.append_basic_block())
    api, nothing = context.get_python_api(builder), ir.Constant(OBJECT, None)
    own, given, many = function.args
    with builder.if_then(builder.icmp_signed("!=", many, COUNT(len(names))), likely=False):
        api.err_set_string("PyExc_TypeError", f"{len(names)} numbers are needed: {', '.join(names)}")
        builder.ret(nothing)
    values = []
    for j in range(len(names)):
        value = api.float_as_double(builder.load(builder.gep(given, [COUNT(j)])))
        either = builder.fcmp_ordered("==", value, value.type(-1.0))  # a number, or an error
        with builder.if_then(either, likely=False), builder.if_then(cgutils.is_not_null(builder, api.err_occurred())):
            builder.ret(nothing)
        values.append(value)
    array = context.make_array(signature.args[-1])(context, builder)
    # what a tuple and an array hold begins after their heads; to ask Python for it takes a twentieth of a command
    for head, kind in ((tuple.__basicsize__, OBJECT), (object.__basicsize__, array.data.type)):
        own = builder.load(builder.bitcast(builder.gep(own, [COUNT(head)]), kind.as_pointer()))
    each = COUNT(context.get_abi_sizeof(array.data.type.pointee))
    populate_array(array, own, [COUNT(size)], [each], each, None)
    callee = context.declare_function(module, compiled.fndesc)
    values.append(array._getvalue())
    _, found = context.call_conv.call_function(builder, callee, signature.return_type, signature.args, values)
    if isinstance(signature.return_type, types.BaseTuple):
        result = api.tuple_new(len(signature.return_type))
        for j in range(len(signature.return_type)):
            api.tuple_setitem(result, j, api.float_from_double(builder.extract_value(found, j)))
    else:
        result = api.float_from_double(found)
    builder.ret(result)
    library.add_ir_module(module)
    library.finalize()
    return library, library.get_pointer_to_function(function.name)
