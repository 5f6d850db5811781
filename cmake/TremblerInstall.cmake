# cmake --install: the program, its data files, and its desktop entry, icon and manual page.
include(GNUInstallDirs)
install(TARGETS trembler RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# The program finds share/trembler relative to its own path, so the installation can be moved as a whole.
install(DIRECTORY assets levels mods DESTINATION share/trembler)
install(FILES packaging/trembler.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES README.md LICENSE THIRD_PARTY.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
if(NOT TREMBLER_HEADLESS)
  install(FILES packaging/trembler.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES packaging/trembler.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()
