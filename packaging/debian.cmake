# A package for Debian, of the files that cmake --install installs: build/package/trembler_VERSION-1_ARCHITECTURE.deb, by
#     cmake --build build --target deb
# Needs dpkg-dev, which finds the packages of the linked libraries, and file.
# Debian's tools find in these variables who makes a package. Without them the address is one that cannot exist, as there
# is no list of mail.
set(maintainer "The authors of Trembler <trembler@packages.invalid>")
if(NOT "$ENV{DEBEMAIL}" STREQUAL "" AND NOT "$ENV{DEBFULLNAME}" STREQUAL "")
  set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()
set(TREMBLER_MAINTAINER "${maintainer}" CACHE STRING "Who answers for the package for Debian: Name <address>")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME trembler)
set(CPACK_PACKAGE_VENDOR "Trembler")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "puzzle game in which physics, not scripts, makes machines work")
set(CPACK_PACKAGE_DESCRIPTION "A player places parts and lets the world run. Rigid bodies, electricity,
magnetism, water and sound are simulated separately and meet only in small
interactions, so every arrangement that would work does.
.
With levels, free play with every part, an editor for levels and parts, and
mods in Lua. Runs repeat to the bit, so solutions can be recorded, shared and
verified; every command but the editor also works without a display.")
set(CPACK_PACKAGE_CONTACT "${TREMBLER_MAINTAINER}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# Whatever the umask is.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
  WORLD_EXECUTE)

set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION games)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What no library's name tells: opened at run time. libgl1 and libegl1 depend on Mesa's drivers.
if(NOT TREMBLER_HEADLESS)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1, fonts-inter | fonts-dejavu-core")
endif()
include(CPack)

find_program(TREMBLER_DPKG dpkg-deb)
if(TREMBLER_DPKG) # other systems have no use for these
  trembler_install_compressed(packaging/changelog changelog.Debian ${trembler_documents})
  install(FILES packaging/lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME trembler)
endif()
add_custom_target(deb COMMAND ${CMAKE_CPACK_COMMAND} -G DEB -B ${PROJECT_BINARY_DIR}/package
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR} DEPENDS trembler USES_TERMINAL VERBATIM)
