#pragma once
#define double float
#error not the kit's
