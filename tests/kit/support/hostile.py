"""Parts that attack."""

import secrets

from bounce_grader.common.manifest import parts


def part(number: int, body: str) -> bytes:
    """A part with hostile lines around the stub's answer. It is compiled anew each time."""
    answers = {
        1: "Contact get_contacts(const Vector3& q, const Parameters&) "
        "{ attack(); return {Jacobian::Constant(q(0)), 0}; }",
        2: "Lcp form_lcp(const Jacobian&, const Vector3& v, const Parameters&) "
        "{ attack(); return {Eigen::Matrix4d::Constant(v(0)), Eigen::Vector4d::Zero()}; }",
        3: "State step(const Vector3& q, const Vector3& v, const Parameters&) "
        "{ attack(); return {q, v}; }",
        4: "Trajectory simulate(const Vector3&, const Vector3&, const Parameters& p) "
        "{ attack(); return {Eigen::Matrix3Xd::Zero(3, p.T), Eigen::Matrix3Xd::Zero(3, p.T)}; }",
    }
    begin = f"// {secrets.token_hex(8)}\n#include <bounce/{parts()[number - 1].stem}.hpp>\n"
    return f"{begin}{body}\nnamespace bounce {{ {answers[number]} }}\n".encode()
