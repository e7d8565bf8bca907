"""JUnit's XML: a test suite for each part, a test case for each check."""

from xml.etree import ElementTree

from bounce_grader.common.escaping import printable, xml_document
from bounce_grader.common.numbers import short
from bounce_grader.formats import sentences
from bounce_grader.grading.report import Report


def render(record: Report) -> str:
    time = f"{record['seconds']['total']:.3f}"
    suites = ElementTree.Element("testsuites", name="bouncing", time=time)
    suites.extend(map(_suite, record["parts"]))
    for count in ("tests", "failures", "errors"):
        suites.set(count, str(sum(int(suite.get(count, "0")) for suite in suites)))
    ElementTree.indent(suites)
    return xml_document(ElementTree.tostring(suites, encoding="unicode", xml_declaration=False))


def _suite(part: sentences.Part) -> ElementTree.Element:
    """The suite of a part. A check that didn't run is an error, a wrong answer a failure."""
    failed = [check for check in part["checks"] if not check["passed"]]
    errors = [check for check in failed if _did_not_run(part, check)]
    counts = {"tests": len(part["checks"]), "failures": len(failed) - len(errors)}
    counts |= {"errors": len(errors), "skipped": 0}
    named = {"name": part["stem"]} | {name: str(count) for name, count in counts.items()}
    suite = ElementTree.Element("testsuite", named)
    properties = ElementTree.SubElement(suite, "properties")
    for name in ("score", "max_score"):
        ElementTree.SubElement(properties, "property", name=name, value=short(part[name]))
    suite.extend(_case(part, check) for check in part["checks"])
    for remark in part.get("remarks", []):
        ElementTree.SubElement(suite, "system-out").text = printable(remark)
    return suite


def _did_not_run(part: sentences.Part, check: sentences.Part) -> bool:
    return part["status"] != "graded" and not check["message"]


def _case(part: sentences.Part, check: sentences.Part) -> ElementTree.Element:
    name = check["id"].partition(".")[2]
    case = ElementTree.Element("testcase", name=name, classname=part["stem"])
    if not check["passed"]:
        kind = "error" if _did_not_run(part, check) else "failure"
        verdict = part["status"] if kind == "error" else "wrong"
        fault = ElementTree.SubElement(case, kind, message=check["title"], type=verdict)
        fault.text = printable(sentences.check_words(part, check))
    return case
