import pytest

pytest.importorskip("matplotlib")
from swarf import reports  # noqa: E402


def test_table():
    assert list(reports.table(["case", "force"], [["a | b", "1.2 +- 0.1 N"], ["c", "-"]])) == [
        "", "| case | force |", "|---|---:|", "| a \\| b | 1.2 +- 0.1 N |", "| c | - |", ""]


def test_table_wider_than_a_screen_comes_in_parts():
    head = [f"column {k:02}" for k in range(20)]
    lines = list(reports.table(head, [[f"value {k} of a row" for k in range(20)]]))
    heads = [line for line in lines if "column" in line]
    assert len(heads) > 1 and all(len(line) <= reports.WIDTH for line in lines)
    assert all(line.startswith("| column 00 |") for line in heads)
    assert sum(line.count("column") for line in heads) == 20 + len(heads) - 1


def test_page_is_wrapped(tmp_path, monkeypatch):
    monkeypatch.setattr(reports, "FOLDER", tmp_path)
    reports.write("page", ["# Page", "", "- " + "word " * 40, "", "| " + "cell " * 40 + "|"])
    lines = (tmp_path / "page.md").read_text().splitlines()
    assert lines[3].startswith("  word") and len(lines[-1]) > reports.WIDTH
