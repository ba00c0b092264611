"""Results on disk: read again as they were, torn lines, other keys, shards put together."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from planar_cli.errors import PlanarError
from planar_cli.homework.sets.paper import RIGHT, Graded, Result
from planar_cli.homework.tasks.results import Line, ResultsFile, handed_in_twice, line_of, merge, result_of, results


def made(student: str, file: str, part: int = 0, parts: int = 1, score: float = 1.0, content: str = "c") -> Line:
    """The line of a result with one find."""
    graded = Graded("p", "a", "5 N", RIGHT, score, 2.0, mistakes=("x", "y"), message="fine\u2028")
    return line_of(Result(student, 3, (graded,), file, ("w",)), (part, parts), (content, "key"), "ok", "")


def written(path: Path, *lines: Line) -> str:
    file = ResultsFile(str(path))
    for line in lines:
        file.write(line)
    file.close()
    return str(path)


def test_a_result_comes_back_as_it_was() -> None:
    line = made("s\u202e1", "in/\udcffs1.yaml")
    assert line.text.isascii()
    assert "\n" not in line.text
    graded = Graded("p", "a", "5 N", RIGHT, 1.0, 2.0, mistakes=("x", "y"), message="fine\u2028")
    assert result_of(line.text) == Result("s\u202e1", 3, (graded,), "in/\udcffs1.yaml", ("w",))
    assert json.loads(line.text)["schema_version"] == 1


def test_shards_are_put_together_and_later_lines_count(tmp_path: Path) -> None:
    one = written(tmp_path / "1", made("b", "b.yaml"), made("a", "a.yaml", score=0.0), made("c", "c.csv", 1, 2))
    two = written(tmp_path / "2", made("a", "a.yaml", score=2.0), made("c", "c.csv", 0, 2))
    assert [(r.source, r.student, r.score) for r in results([one, two])] == [
        ("a.yaml", "a", 2.0),
        ("b.yaml", "b", 1.0),
        ("c.csv", "c", 1.0),
        ("c.csv", "c", 1.0),
    ]
    assert next(r.score for r in results([two, one])) == 0.0
    assert list(merge([one, two])) == list(merge([one, two]))


def test_of_a_changed_file_the_last_content_counts(tmp_path: Path) -> None:
    old = [made(f"s{i}", "c.csv", i, 3) for i in range(3)]
    file = written(tmp_path / "r", *old, made("t", "c.csv", 0, 2, content="d"), made("u", "c.csv", 1, 2, content="d"))
    assert [r.student for r in results([file])] == ["t", "u"]


def test_different_keys_are_refused(tmp_path: Path) -> None:
    one = written(tmp_path / "1", made("a", "a.yaml"))
    two = written(tmp_path / "2", line_of(Result("b", 0, (), "b.yaml"), (0, 1), ("c", "other"), "ok", ""))
    with pytest.raises(PlanarError, match=r"a\.yaml \(in .*1\) and b\.yaml \(in .*2\) were graded with different keys"):
        list(merge([one, two]))


def test_a_torn_line_is_none_and_is_written_over(tmp_path: Path) -> None:
    file = tmp_path / "r"
    written(file, made("a", "a.yaml"))
    with file.open("a") as stream:
        stream.write('{"file": "b.ya')
    assert [r.student for r in results([str(file)])] == ["a"]
    written(file, made("c", "c.yaml"))
    assert [r.student for r in results([str(file)])] == ["a", "c"]


@pytest.mark.parametrize("text", ["x\n", "{}\n", "[1]\n", '{"file": 1}\n', "[" * 100_000 + "\n"])
def test_what_is_no_results_file_is_left_alone(tmp_path: Path, text: str) -> None:
    file = tmp_path / "r"
    file.write_text(text)
    with pytest.raises(PlanarError, match="r:1: this is no line of results"):
        ResultsFile(str(file))
    assert file.read_text() == text
    with pytest.raises(PlanarError, match="this is no line of results"):
        list(merge([str(file)]))


def test_where_results_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "victim")
    for name in ("link", ".", "no/r"):
        with pytest.raises(PlanarError, match="the results cannot be written to"):
            ResultsFile(str(tmp_path / name))
    assert not (tmp_path / "victim").exists()
    with pytest.raises(PlanarError, match="cannot be read: No such file"):
        list(merge([str(tmp_path / "none")]))


def test_one_run_at_a_time(tmp_path: Path) -> None:
    first = ResultsFile(str(tmp_path / "r"))
    with pytest.raises(PlanarError, match="another run is writing to"):
        ResultsFile(str(tmp_path / "r"))
    first.close()
    ResultsFile(str(tmp_path / "r")).close()


def test_who_handed_in_twice(tmp_path: Path) -> None:
    one = written(tmp_path / "1", made("a", "a.yaml"), made("b", "b.yaml"))
    two = written(tmp_path / "2", *(made("a", f"z{i}.yaml") for i in range(6)))
    assert handed_in_twice([one, two]) == [
        "a handed in 7 times: a.yaml, z0.yaml, z1.yaml, z2.yaml, …; "
        "all are graded, the last that can be counts in the average",
    ]
