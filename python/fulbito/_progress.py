"""Progress bars by tqdm, which is optional."""

from types import TracebackType
from typing import Any, Optional

from fulbito.errors import UsageError

__all__ = ["Bar"]


class Bar:
    """A bar while work goes on; nothing unless it is `shown`."""

    def __init__(self, shown: bool, title: str, unit: str) -> None:
        self._bar: Any = None
        if not shown:
            return
        try:
            from tqdm.auto import tqdm
        except ImportError:
            raise UsageError("progress=True needs tqdm: pip install 'fulbito[progress]'") from None
        self._bar = tqdm(desc=title, unit=unit)

    def __enter__(self) -> "Bar":
        return self

    def __exit__(self, kind: Optional[type[BaseException]], value: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        if self._bar is not None:
            self._bar.close()

    def match(self, ticks: int, blue: int, yellow: int) -> None:
        """Ticks of play so far, and the score."""
        self._bar.set_postfix_str(f"{blue} : {yellow}", refresh=False)
        self._bar.update(ticks - self._bar.n)

    def work(self, done: int, total: int) -> None:
        """Tasks done so far, of all tasks."""
        self._bar.total = total
        self._bar.update(done - self._bar.n)
