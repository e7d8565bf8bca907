#pragma once
#ifdef _MSC_VER
#pragma warning(disable : 4244)
#endif
#define _USE_MATH_DEFINES
#include <cmath>
#include <Eigen/Dense>
#ifdef _WIN32
#include "Helpers\Square.h"
#else
#include "Helpers/Square.h"
#endif
