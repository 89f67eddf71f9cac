# Finds the two OpenCV modules the core uses. Debian ships OpenCVConfig.cmake only in the full libopencv-dev,
# which costs 300 MB more than the module packages libopencv-core-dev and libopencv-imgproc-dev.
# Defines the targets opencv_core and opencv_imgproc; their headers are SYSTEM (they warn under C++20).

find_path(OpenCVModules_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4)
find_library(OpenCVModules_CORE opencv_core)
find_library(OpenCVModules_IMGPROC opencv_imgproc)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCVModules REQUIRED_VARS OpenCVModules_CORE OpenCVModules_IMGPROC
                                  OpenCVModules_INCLUDE_DIR)

if(OpenCVModules_FOUND AND NOT TARGET opencv_core)
  foreach(module CORE IMGPROC)
    string(TOLOWER opencv_${module} target)
    add_library(${target} UNKNOWN IMPORTED)
    set_target_properties(${target} PROPERTIES IMPORTED_LOCATION ${OpenCVModules_${module}}
                          INTERFACE_INCLUDE_DIRECTORIES ${OpenCVModules_INCLUDE_DIR})
  endforeach()
  set_target_properties(opencv_imgproc PROPERTIES INTERFACE_LINK_LIBRARIES opencv_core)
endif()
mark_as_advanced(OpenCVModules_INCLUDE_DIR OpenCVModules_CORE OpenCVModules_IMGPROC)
