#pragma once

// Those who embed fingerpad see it too.
#include "fingerpad/tick_record.hpp"
