#pragma once

#include <bounce/types.hpp>

// The force and moment of the ground on the square, zero in flight.
bounce::Vector3 contact_force(const bounce::Contact& contact, const bounce::Vector3& v, const bounce::Parameters& params);
bool in_contact(const bounce::Vector3& q, const bounce::Parameters& params);
