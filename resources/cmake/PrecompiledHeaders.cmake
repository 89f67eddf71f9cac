# Most of the time a file takes to compile goes into the same large headers; here they are parsed once per kind of file:
#   pch_core, pch_app, pch_ui      what `core` uses; that and Qt without a screen; that and Qt Widgets
#   pch_core_tests, pch_ui_tests   the same with GoogleTest, for the tests (which are not optimised)
# A folder says which it wants: set(ECHOTRAIL_PCH pch_ui). Every file still includes what it uses; a build with
# -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON shows whether it does.

set(pch_core_headers <algorithm> <array> <chrono> <cmath> <cstdint> <deque> <functional> <map> <memory> <optional> <set>
                     <span> <string> <string_view> <variant> <vector> <Eigen/Core> <Eigen/LU> <opencv2/core.hpp>)
set(pch_app_headers ${pch_core_headers} <QByteArray> <QHostAddress> <QString> <QTcpSocket> <QTimer> <QUdpSocket>)
set(pch_ui_headers ${pch_core_headers} <QAction> <QApplication> <QBoxLayout> <QComboBox> <QLabel> <QMainWindow>
                   <QPainter> <QPushButton> <QSettings> <QTimer> <QToolButton>)
set(pch_core_links Eigen3::Eigen opencv_core)
set(pch_app_links ${pch_core_links} Qt6::Network)
set(pch_ui_links ${pch_core_links} Qt6::Widgets)

function(echotrail_pch name)
  cmake_parse_arguments(PARSE_ARGV 1 pch "" "" "HEADERS;LINKS;OPTIONS")
  file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/pch/${name}.cpp CONTENT "")
  add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/pch/${name}.cpp)
  target_link_libraries(${name} PRIVATE project_settings ${pch_LINKS})
  target_compile_options(${name} PRIVATE ${pch_OPTIONS})
  target_precompile_headers(${name} PRIVATE ${pch_HEADERS})
endfunction()

# use_pch(TARGET): the kind that this folder asks for.
function(use_pch target)
  if(DEFINED ECHOTRAIL_PCH)
    target_precompile_headers(${target} REUSE_FROM ${ECHOTRAIL_PCH})
  endif()
endfunction()
