# cmake --install: the program, its data files, its documents, and its desktop entry, icon and manual page. The package
# for Debian contains the same: packaging/debian.cmake.
include(GNUInstallDirs)
set(trembler_documents ${CMAKE_INSTALL_DATAROOTDIR}/doc/trembler) # GNUInstallDirs would spell the name as project() does
install(TARGETS trembler RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# The program finds share/trembler relative to its own path, so the installation can be moved as a whole.
install(DIRECTORY assets levels mods DESTINATION share/trembler)
install(FILES packaging/copyright README.md THIRD_PARTY.md DESTINATION ${trembler_documents})
install(DIRECTORY docs/ DESTINATION ${trembler_documents}/docs)
# The licences of libraries that become part of the program's file, because they are headers or linked statically, ask for
# their text beside it. Those of shared libraries come with them.
foreach(package libcli11-dev libeigen3-dev libimgui-dev libluajit-5.1-dev nlohmann-json3-dev)
  if(EXISTS /usr/share/doc/${package}/copyright AND NOT (TREMBLER_HEADLESS AND package STREQUAL "libimgui-dev"))
    install(FILES /usr/share/doc/${package}/copyright DESTINATION ${trembler_documents}/licences RENAME ${package})
  endif()
endforeach()
if(NOT TREMBLER_HEADLESS)
  install(FILES packaging/trembler.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES packaging/trembler.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()

# Manual pages and changelogs are installed compressed, without a time in the file, so that the same sources give the same bytes.
find_program(TREMBLER_GZIP gzip)
function(trembler_install_compressed file name destination)
  set(source ${PROJECT_SOURCE_DIR}/${file})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  if(TREMBLER_GZIP)
    set(made ${PROJECT_BINARY_DIR}/compressed/${name}.gz)
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/compressed)
    execute_process(COMMAND ${TREMBLER_GZIP} -9nc ${source} OUTPUT_FILE ${made} COMMAND_ERROR_IS_FATAL ANY)
    install(FILES ${made} DESTINATION ${destination})
  else()
    install(FILES ${source} DESTINATION ${destination} RENAME ${name})
  endif()
endfunction()
trembler_install_compressed(packaging/trembler.1 trembler.1 ${CMAKE_INSTALL_MANDIR}/man1)
trembler_install_compressed(CHANGELOG.md changelog ${trembler_documents})

include(packaging/debian.cmake)
