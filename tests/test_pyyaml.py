"""Regular expressions of modules that are loaded meanwhile wait for their first use."""

from __future__ import annotations

import re
import subprocess
import sys

from planar_cli.problem.nodes.pyyaml import compiled_when_used

LOADED = """
import re
from planar_cli.problem.nodes import nodes
import yaml
assert type(yaml.reader.Reader.NON_PRINTABLE).__name__ == "_Pattern" and re.compile("a").match("a")
for loader in (yaml.SafeLoader, yaml.CSafeLoader):
    read = yaml.load("a: [1, 2.5, yes, 2020-01-01T10:20:30, ~, 0x1F, 1:30]", Loader=loader)["a"]
    assert read[:3] + read[4:] == [1, 2.5, True, None, 31, 90] and read[3].minute == 20
try:
    yaml.load("a: \\x01", Loader=yaml.SafeLoader)
except yaml.reader.ReaderError:
    print("refused")
"""


def test_a_pattern_waits() -> None:
    with compiled_when_used():
        late = re.compile("b+", re.IGNORECASE)
    assert type(re.compile("b")) is re.Pattern
    assert late.fullmatch("bBb")
    assert late.sub("c", "abba") == "aca"


def test_yaml_reads_as_ever() -> None:
    done = subprocess.run([sys.executable, "-c", LOADED], capture_output=True, text=True, check=False)
    assert done.stdout == "refused\n", done.stderr
