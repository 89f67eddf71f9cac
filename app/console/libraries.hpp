#pragma once

#include "ui/manual/reference_pages.hpp"

#include <vector>

namespace echotrail {

/// What the console was built from, with the versions that are in use now where the library tells.
std::vector<LibraryNotice> libraries();

}  // namespace echotrail
