# What `cmake --install` puts where, and the Debian package that `cpack` makes of it. Presets, scenarios, translations,
# manual and pictures are in the programs: nothing has to be found at run time.
include(GNUInstallDirs)
install(TARGETS echotrail echotrail-console RUNTIME)
set(desktop ${CMAKE_SOURCE_DIR}/resources/desktop)
install(FILES ${desktop}/echotrail-console.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${desktop}/echotrail-console.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${desktop}/echotrail.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${desktop}/echotrail-console.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES ${desktop}/echotrail-console.png DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/128x128/apps)
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES ${CMAKE_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME echotrail)
set(CPACK_PACKAGE_CONTACT "The Echotrail authors <echotrail@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_DESCRIPTION "Follows targets in the echoes of a Tritech SeaKing, live or recorded (.echotrail,
Seanet Pro .V4LOG), and shows an operator what it sees and why. Holds the desktop
console (echotrail-console) and the tracker without a screen (echotrail).")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# fonts-dejavu-core: without any font every text is boxes; the others look better and hold Chinese, Wayland and Qt's own
# dialogs in Chinese.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-noto-core, fonts-noto-cjk, qt6-wayland, qt6-translations-l10n")
if(CMAKE_CXX_FLAGS_RELEASE MATCHES "x86-64-v3")
  # The package refuses a processor on which the programs would die of an illegal instruction.
  set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/resources/desktop/preinst)
endif()
include(CPack)
