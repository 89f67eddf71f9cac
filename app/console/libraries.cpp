#include "libraries.hpp"

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <google/protobuf/stubs/common.h>
#include <nlohmann/json.hpp>
#include <opencv2/core/version.hpp>
#include <openssl/crypto.h>
#include <sqlite3.h>
#include <toml++/toml.h>

#include <QStringList>

namespace echotrail {
namespace {

template <class... Numbers>
QString version(Numbers... numbers) {
    return QStringList{QString::number(numbers)...}.join('.');
}

}  // namespace

std::vector<LibraryNotice> libraries() {
    constexpr int pb = GOOGLE_PROTOBUF_VERSION;
    return {
        {"Qt", qVersion(), "LGPL-3.0 / GPL-2.0+", "windows, links"},
        {"OpenCV", CV_VERSION, "Apache-2.0", "images"},
        {"Eigen", version(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION), "MPL-2.0", "algebra"},
        {"SQLite", sqlite3_libversion(), "public domain", "recordings"},
        {"Protocol Buffers", version(pb / 1'000'000, pb / 1000 % 1000, pb % 1000), "BSD-3-Clause", "link"},
        {"OpenSSL", OpenSSL_version(OPENSSL_VERSION_STRING), "Apache-2.0", "encrypted links"},
        {"toml++", version(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH), "MIT", "parameter files"},
        {"JSON for Modern C++",
         version(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH), "MIT",
         "results"},
        {"CLI11", CLI11_VERSION, "BSD-3-Clause", "command line"}};
}

}  // namespace echotrail
