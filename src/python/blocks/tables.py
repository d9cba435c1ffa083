"""Tables of rows with named columns: a pandas DataFrame, or a structured array without pandas."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

__all__ = ["table_of"]


def table_of(rows: Sequence[Mapping[str, Any]]) -> Any:
    """Returns rows with the same keys as a table."""
    try:
        import pandas
    except ImportError:
        names = list(rows[0]) if rows else []
        columns = {name: np.asarray([row[name] for row in rows]) for name in names}
        table = np.zeros(len(rows), dtype=[(name, columns[name].dtype) for name in names])
        for name in names:
            table[name] = columns[name]
        return table
    return pandas.DataFrame(list(rows))
