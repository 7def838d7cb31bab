#pragma once

// Those who embed fingerpad see them too.
#include "fingerpad/types.hpp"
