#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params)
{
    const Contact contact = get_contacts(q, params);
    const Eigen::Matrix3d Minv = params.M().inverse();

    Vector3 force;
    Vector3 correction = Vector3::Zero();
    if (contact.phi < params.delta)
    {
        const Lcp lcp = form_lcp(contact.J, v, params);
        const Vector3 f = solve_lcp(lcp.V, lcp.p);
        force = contact.J.col(1) * f(0) - contact.J.col(0) * f(1) + contact.J.col(0) * f(2);
        correction(1) = params.delta;
    }
    else
    {
        force = params.M() * params.g;
    }

    const Vector3 vNext = v + params.dt * Minv * force;
    const Vector3 qNext = q + params.dt * vNext + correction;
    return {qNext, vNext};
}

}  // namespace bounce
