"""Compiling an entry: one object file of a function and all that it calls, which needs neither Numba nor Python.

Numba compiles function by function, optimises each with copies of all that it calls, and makes machine code of it, so
that work is done many times over. Here what an entry calls is only translated; the whole is optimised once, and alone
turned into machine code. It gets its memory from the C library in place of Numba's runtime, and a few lines around it
read arrays where NumPy keeps them.

For this, Numba is told of another target, by the interface that it has for those who add a processor. So functions
that are compiled for anyone else are not touched, and do not matter here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from llvmlite import ir
from numba.core import types
from numba.core.codegen import JITCodeLibrary, JITCPUCodegen
from numba.core.compiler_lock import global_compiler_lock
from numba.core.cpu import CPUContext, CPUTargetOptions
from numba.core.descriptors import TargetDescriptor
from numba.core.dispatcher import Dispatcher
from numba.core.extending import overload
from numba.core.target_extension import CPU, dispatcher_registry, jit_registry, target_override, target_registry
from numba.core.typing.context import Context as TypingContext
from numba.np import arrayobj

from nonhertz.compiled.arguments import ArrayType, TupleType
from nonhertz.compiled.decorator import ENTRIES, Compiled
from nonhertz.compiled.dispatching import OPTIONS, slp_vectorised
from nonhertz.compiled.native import OTHER_TYPES, ObjectCode

_BYTE, _WORD, _LONG, _REAL = ir.IntType(8), ir.IntType(32), ir.IntType(64), ir.DoubleType()
_POINTER = _BYTE.as_pointer()

# Where NumPy keeps what, counted from the end of what every Python object begins with: `PyArrayObject_fields` and
# `PyArray_Descr` in its C interface.
_HEAD = object.__basicsize__
_DATA, _DIMENSIONS, _SHAPE, _ELEMENT, _FLAGS = (_HEAD + each for each in (0, 8, 16, 40, 48))
_BYTE_ORDER, _ELEMENT_NUMBER = _HEAD + 10, _HEAD + 12
_CONTIGUOUS_AND_ALIGNED = 0x0001 | 0x0100


class _Draft(JITCodeLibrary):
    """A module that others will contain: neither optimised nor turned into machine code by itself."""

    def _optimize_final_module(self) -> None:
        pass

    def _finalize_final_module(self) -> None:
        this: Any = self
        this._finalize_dynamic_globals()
        self._finalized = True


class _Codegen(JITCPUCodegen):
    _library_class = _Draft


class _Context(CPUContext):
    def init(self) -> None:
        super().init()
        codegen: Any = _Codegen
        self._internal_codegen = codegen(ENTRIES)

    def get_executable(self, library: Any, fndesc: Any, env: Any) -> Any:
        """Return what stands for a function; nobody calls it."""
        return object()


class _Target(TargetDescriptor):
    options = CPUTargetOptions

    def __init__(self) -> None:
        parent: Any = super()
        parent.__init__(ENTRIES)
        kind: Any = _Context
        self._typing = TypingContext()
        self._context = kind(self._typing, ENTRIES)

    @property
    def typing_context(self) -> Any:
        return self._typing

    @property
    def target_context(self) -> Any:
        return self._context


class _Entries(CPU):
    """The same processor, under another name."""


target_registry[ENTRIES] = _Entries
_target = _Target()


class _PartDispatcher(Dispatcher):
    targetdescr = _target

    def add_overload(self, result: Any) -> None:
        self.overloads[tuple(result.signature.args)] = result


def _jit(function: Any = None, **options: Any) -> Any:
    """Do for this target what `numba.jit` does, for the functions that Numba itself is written in."""
    if function is None:
        return lambda function: _jit(function, **options)
    chosen = {name: value for name, value in options.items() if name not in {"cache", "pipeline_class", "target"}}
    return _PartDispatcher(function, targetoptions={"nopython": True, "boundscheck": None} | chosen)


dispatcher_registry[_Entries] = _PartDispatcher
jit_registry[_Entries] = _jit


def _raise_plainly(source: Any, index: Any) -> Any:
    # Numba's text with both shapes in it takes longer to compile than a solver, and needs Python.
    def implementation(source: Any, index: Any) -> None:
        raise ValueError("cannot assign slice from input of different size")

    return implementation


if hasattr(arrayobj, "raise_with_shape_context"):  # older versions have no such text
    overload(arrayobj.raise_with_shape_context, target=ENTRIES)(_raise_plainly)


def part(function: Callable[..., object]) -> Any:
    """Return what entries call for ``function``."""
    return _jit(function, no_cpython_wrapper=True, no_cfunc_wrapper=True, **OPTIONS)


def build(function: Compiled, arguments: Sequence[Any], symbol: str) -> ObjectCode:
    """Compile a function and all that it calls.

    Parameters
    ----------
    function : Compiled
        The function.
    arguments : sequence
        The types of its arguments, as from `nonhertz.compiled.arguments.type_of`.
    symbol : str
        The name to give it.
    """
    kinds = tuple(_numba_type(each) for each in arguments)
    with global_compiler_lock, target_override(ENTRIES), slp_vectorised():
        dispatcher = function._numba_type_.dispatcher
        dispatcher.compile(kinds)
        result = dispatcher.overloads[kinds]
        library = _linked(result, symbol)
        library._optimize_final_module()
        module = library._final_module
        module.verify()
        code = library.codegen._tm.emit_object(module)
    needs = (each.name for each in module.functions if each.is_declaration and not each.name.startswith("llvm."))
    return ObjectCode(symbol, _result_name(result.signature.return_type), tuple(needs), code)


def _numba_type(kind: Any) -> Any:
    if isinstance(kind, ArrayType):
        return types.Array(getattr(types, kind.element), kind.dimensions, "C")
    if isinstance(kind, TupleType):
        return types.BaseTuple.from_types([_numba_type(each) for each in kind.parts], kind.form)
    return {float: types.float64, int: types.int64, bool: types.boolean}[kind]


def _result_name(kind: Any) -> str:
    for known, name in ((types.none, "None"), (types.float64, "float"), (types.int64, "int"), (types.boolean, "bool")):
        if kind == known:
            return name
    raise TypeError(f"An entry returns nothing or one float, int or bool, not {kind}: have it fill an array.")


def _linked(result: Any, symbol: str) -> Any:
    """Return one module with a function of this name, visible from outside, and all that it calls, which is not."""
    context = _target.target_context
    library = JITCodeLibrary(context.codegen(), symbol)
    library.add_ir_module(_frame(context, result, symbol))
    library.add_ir_module(_memory())
    result.library._ensure_finalized()
    module = library._final_module
    module.link_in(result.library._get_module_for_linking(), preserve=True)
    for each in (*module.functions, *module.global_variables):
        if not each.is_declaration and each.name != symbol:
            each.linkage = "internal"
    return library


def _frame(context: Any, result: Any, symbol: str) -> Any:
    """Return a module with the function that Python calls: it checks and gathers the arguments."""
    signature = result.signature
    module = context.create_module(f"frame.{symbol}")
    parts = [each for kind in signature.args for each in _parts(kind)]
    passed = [{types.int64: _LONG, types.boolean: _BYTE}.get(each, _REAL) for each in parts if not _is_array(each)]
    function = ir.Function(module, ir.FunctionType(_WORD, [_POINTER, _POINTER, *passed]), symbol)
    outcome, objects, *numbers = function.args
    builder = ir.IRBuilder(function.append_basic_block())
    kinds = [each for each in parts if _is_array(each)]
    arrays = [_field(builder, objects, tuple.__basicsize__ + 8 * index, _POINTER) for index in range(len(kinds))]
    fits: Any = ir.Constant(ir.IntType(1), 1)
    for kind, array in zip(kinds, arrays, strict=True):
        fits = builder.and_(fits, _is_array_of(builder, array, kind))
    with builder.if_then(builder.not_(fits), likely=False):
        builder.ret(ir.Constant(_WORD, OTHER_TYPES))

    remaining = iter(arrays), iter(numbers)
    arguments = [_gathered(context, builder, kind, *remaining) for kind in signature.args]
    callee = context.declare_function(module, result.fndesc)
    status, found = context.call_conv.call_function(builder, callee, signature.return_type, signature.args, arguments)
    with builder.if_then(status.is_error, likely=False):
        for index, offset in ((0, 8), (1, 16)):
            field = builder.load(builder.gep(status.excinfoptr, [_WORD(0), _WORD(index)]))
            builder.store(field, _at(builder, outcome, offset, field.type))
        builder.ret(status.code)
    if signature.return_type != types.none:
        stored = context.get_value_as_data(builder, signature.return_type, found)
        builder.store(stored, _at(builder, outcome, 0, stored.type))
    builder.ret(ir.Constant(_WORD, 0))
    return module


def _within(kind: Any) -> tuple[Any, ...] | None:
    """Return the types in a tuple, or None if this is not the type of a tuple."""
    return tuple(getattr(kind, "types", ())) if isinstance(kind, types.BaseTuple) else None


def _parts(kind: Any) -> Iterator[Any]:
    within = _within(kind)
    if within is None:
        yield kind
    for each in within or ():
        yield from _parts(each)


def _is_array(kind: Any) -> bool:
    return isinstance(kind, types.Array)


def _gathered(context: Any, builder: Any, kind: Any, arrays: Iterator[Any], numbers: Iterator[Any]) -> Any:
    """Return an argument as Numba's functions take it."""
    within = _within(kind)
    if within is not None:
        values = [_gathered(context, builder, each, arrays, numbers) for each in within]
        return context.make_tuple(builder, kind, values)
    if _is_array(kind):
        return _array(context, builder, kind, next(arrays))
    value = next(numbers)
    return builder.icmp_unsigned("!=", value, _BYTE(0)) if kind == types.boolean else value


def _array(context: Any, builder: Any, kind: Any, value: Any) -> Any:
    size = context.get_abi_sizeof(context.get_data_type(kind.dtype))
    lengths = _field(builder, value, _SHAPE, _POINTER)
    shape = [_field(builder, lengths, 8 * axis, _LONG) for axis in range(kind.ndim)]
    strides: list[Any] = [_LONG(size)]
    for length in reversed(shape[1:]):
        strides.insert(0, builder.mul(strides[0], length))
    array = context.make_array(kind)(context, builder)
    data = builder.bitcast(_field(builder, value, _DATA, _POINTER), array.data.type)
    arrayobj.populate_array(array, data, shape, strides[: kind.ndim], _LONG(size), meminfo=None)
    return array._getvalue()


def _is_array_of(builder: Any, value: Any, kind: Any) -> Any:
    """Return whether an array has the elements and dimensions for which the function was compiled."""
    element = _field(builder, value, _ELEMENT, _POINTER)
    number = np.dtype(str(kind.dtype)).num
    flags = builder.and_(_field(builder, value, _FLAGS, _WORD), _WORD(_CONTIGUOUS_AND_ALIGNED))
    same = (
        builder.icmp_signed("==", _field(builder, element, _ELEMENT_NUMBER, _WORD), _WORD(number)),
        builder.icmp_signed("!=", _field(builder, element, _BYTE_ORDER, _BYTE), _BYTE(ord(">"))),
        builder.icmp_signed("==", _field(builder, value, _DIMENSIONS, _WORD), _WORD(kind.ndim)),
        builder.icmp_signed("==", flags, _WORD(_CONTIGUOUS_AND_ALIGNED)),
    )
    return builder.and_(builder.and_(same[0], same[1]), builder.and_(same[2], same[3]))


def _at(builder: Any, base: Any, offset: int, kind: Any) -> Any:
    return builder.bitcast(builder.gep(base, [_LONG(offset)]), kind.as_pointer())


def _field(builder: Any, base: Any, offset: int, kind: Any) -> Any:
    return builder.load(_at(builder, base, offset, kind))


def _memory() -> Any:
    """Return a module with the functions of Numba's runtime that arrays need, on top of the C library's.

    A block begins with its count of references, its destructor and what that needs, the address of its data, and their
    size, as Numba's functions expect it.
    """
    module = ir.Module("memory")
    malloc = ir.Function(module, ir.FunctionType(_POINTER, [_LONG]), "malloc")
    free = ir.Function(module, ir.FunctionType(ir.VoidType(), [_POINTER]), "free")
    for name, alignments in (
        ("NRT_MemInfo_alloc", 0), ("NRT_MemInfo_alloc_safe", 0),
        ("NRT_MemInfo_alloc_aligned", 1), ("NRT_MemInfo_alloc_safe_aligned", 1),
    ):  # fmt: skip
        _define_block(module, malloc, name, alignments)
    for name, result, argument, callee in (
        ("NRT_Allocate", _POINTER, _LONG, malloc), ("NRT_Free", ir.VoidType(), _POINTER, free),
        ("NRT_MemInfo_call_dtor", ir.VoidType(), _POINTER, free),
    ):  # fmt: skip
        function = ir.Function(module, ir.FunctionType(result, [argument]), name)
        builder = ir.IRBuilder(function.append_basic_block())
        value = builder.call(callee, function.args)
        builder.ret_void() if result == ir.VoidType() else builder.ret(value)
    return module


def _define_block(module: Any, malloc: Any, name: str, alignments: int) -> None:
    head = 64
    function = ir.Function(module, ir.FunctionType(_POINTER, [_LONG, *[_WORD] * alignments]), name)
    size = function.args[0]
    builder = ir.IRBuilder(function.append_basic_block())
    alignment = builder.zext(function.args[1], _LONG) if alignments else _LONG(16)
    block = builder.call(malloc, [builder.add(builder.add(size, alignment), _LONG(head))])
    with builder.if_then(builder.icmp_unsigned("==", block, ir.Constant(_POINTER, None)), likely=False):
        builder.ret(ir.Constant(_POINTER, None))
    # The next address that is a multiple of the alignment, a power of two.
    first = builder.add(builder.ptrtoint(block, _LONG), builder.add(alignment, _LONG(head - 1)))
    data = builder.inttoptr(builder.and_(first, builder.neg(alignment)), _POINTER)
    nothing = ir.Constant(_POINTER, None)
    for index, value in enumerate((_LONG(1), nothing, nothing, data, size)):
        builder.store(value, _at(builder, block, 8 * index, value.type))
    builder.ret(block)
