"""Trained policies as ONNX files: from an environment's observations to actions.

    policy = Policy.load("striker.onnx")
    action = policy(observation)

A file knows for which environment it was made. It needs `pip install "fulbito[onnx]"`. `fulbito.policy_team` plays a file as
a team.
"""

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Mapping, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from fulbito.errors import FileError, InputError, UsageError

__all__ = ["Policy", "PolicyMaker", "save_policy"]

_FORMAT = 1


@dataclass(frozen=True)
class PolicyMaker:
    """What a policy was made for; part of its file."""

    environment: str
    """Identifier of the environment, such as "fulbito/VSS-v0"."""
    options: Mapping[str, Any] = field(default_factory=dict)
    """Arguments of `gymnasium.make` that observations and actions depend on."""
    note: str = ""
    """Any words: how it was trained."""


class Policy:
    """A policy that ONNX Runtime evaluates on one thread."""

    def __init__(self, path: Union[str, Path], session: Any, maker: PolicyMaker) -> None:
        """Use `Policy.load`."""
        self.path = Path(path)
        self.maker = maker
        self._session = session
        self.observation_size = int(session.get_inputs()[0].shape[1])
        """Numbers of an observation."""
        self.action_size = int(session.get_outputs()[0].shape[1])
        """Numbers of an action, each within -1 ... 1."""

    @staticmethod
    def load(path: Union[str, Path]) -> "Policy":
        """Reads a file of `save_policy`. Raises FileError, InputError; UsageError if ONNX Runtime is missing."""
        if not Path(path).is_file():
            raise FileError(f"{path}: there is no such file")
        try:
            import onnxruntime
        except ImportError as error:
            raise UsageError('a policy needs ONNX Runtime: pip install "fulbito[onnx]"') from error
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = 1
        options.inter_op_num_threads = 1
        options.log_severity_level = 4
        try:
            session = onnxruntime.InferenceSession(str(path), options, providers=["CPUExecutionProvider"])
            maker = _maker_of(session.get_modelmeta().custom_metadata_map)
            return Policy(path, session, maker)
        except InputError as error:
            raise InputError(f"{path}: {error}") from error
        except Exception as error:  # ONNX Runtime has many
            raise InputError(f"{path}: this is no ONNX file of a policy: {error}") from error

    def __call__(self, observation: ArrayLike) -> NDArray[np.float32]:
        """The action for an observation of shape (n,), or those for a batch of shape (count, n): float32 within -1 ... 1.

        Raises UsageError for a wrong shape, or numbers that are not finite.
        """
        given = np.asarray(observation, dtype=np.float32)
        if given.ndim not in (1, 2) or given.shape[-1] != self.observation_size:
            raise UsageError(f"an observation of this policy has {self.observation_size} numbers; the shape is {given.shape}")
        if not np.isfinite(given).all():
            raise UsageError("an observation has a NaN or an infinity")
        actions: NDArray[np.float32] = self._session.run(None, {"observation": np.atleast_2d(given)})[0]
        return actions if given.ndim == 2 else actions[0]


def _maker_of(metadata: Mapping[str, str]) -> PolicyMaker:
    text = metadata.get("fulbito")
    if text is None:
        raise InputError("it does not say for which environment it was made")
    try:
        known = json.loads(text)
        if known["format"] != _FORMAT:
            raise InputError(f"it has format {known['format']}; this version reads {_FORMAT}")
        return PolicyMaker(str(known["environment"]), dict(known["options"]), str(known["note"]))
    except (ValueError, KeyError, TypeError) as error:
        raise InputError(f"what it says of its environment is broken: {error}") from error


def save_policy(path: Union[str, Path], layers: Sequence[tuple[ArrayLike, ArrayLike]], maker: PolicyMaker) -> None:
    """Writes a network of dense layers as ONNX: tanh after each layer but the last, whose outputs are clipped to -1 ... 1.

    `layers`: pairs of weights of shape (outputs, inputs) and biases of shape (outputs,), float. Raises UsageError for shapes
    that do not fit, or if the package `onnx` is missing; FileError.
    """
    try:
        import onnx
        from onnx import TensorProto, helper, numpy_helper
    except ImportError as error:
        raise UsageError('writing a policy needs the package onnx: pip install "fulbito[onnx]"') from error
    arrays = [(np.asarray(w, dtype=np.float32), np.asarray(b, dtype=np.float32)) for w, b in layers]
    if not arrays:
        raise UsageError("a policy has at least one layer")
    nodes, constants, name = [], [], "observation"
    for i, (weights, biases) in enumerate(arrays):
        fits = weights.ndim == 2 and biases.shape == weights.shape[:1]
        if not fits or (i > 0 and weights.shape[1] != arrays[i - 1][0].shape[0]):
            raise UsageError(f"layer {i}: weights {weights.shape} and biases {biases.shape} do not fit")
        constants += [numpy_helper.from_array(weights, f"w{i}"), numpy_helper.from_array(biases, f"b{i}")]
        nodes.append(helper.make_node("Gemm", [name, f"w{i}", f"b{i}"], [f"y{i}"], transB=1))
        name = f"y{i}"
        if i + 1 < len(arrays):
            nodes.append(helper.make_node("Tanh", [name], [f"t{i}"]))
            name = f"t{i}"
    constants += [numpy_helper.from_array(np.array(-1, np.float32), "low"), numpy_helper.from_array(np.array(1, np.float32), "high")]
    nodes.append(helper.make_node("Clip", [name, "low", "high"], ["action"]))
    graph = helper.make_graph(
        nodes, "policy", [helper.make_tensor_value_info("observation", TensorProto.FLOAT, ["count", arrays[0][0].shape[1]])],
        [helper.make_tensor_value_info("action", TensorProto.FLOAT, ["count", arrays[-1][0].shape[0]])], constants)
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], ir_version=8, producer_name="fulbito")
    known = {"format": _FORMAT, "environment": maker.environment, "options": dict(maker.options), "note": maker.note}
    helper.set_model_props(model, {"fulbito": json.dumps(known)})
    try:
        onnx.save(model, str(path))
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from error
