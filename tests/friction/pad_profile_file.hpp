#pragma once

// Where tests/study/profile_fit_test.cpp still looks for it.
#include "scene/pad_profile_file.hpp"
