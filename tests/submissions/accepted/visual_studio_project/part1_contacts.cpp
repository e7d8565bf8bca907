#include "pch.h"
#include <bounce/part1_contacts.hpp>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params)
{
	const Eigen::Vector2d r = Square(params.l, q.z()).LowestCorner();

	Contact contact;
	contact.J << 1.0, 0.0,
		0.0, 1.0,
		-r.y(), r.x();
	contact.phi = q.y() + r.y();
	return contact;
}

}
