# OpenFOAM 1912: headers from SLIDEWAVE_OPENFOAM_SOURCE (foam_side/fetch_headers.sh fills it where the
# distribution's packages have none), libraries from the system or from an own build in WM_PROJECT_DIR.
#
# Gives OpenFOAM_FOUND, OpenFOAM_VERSION and the imported target OpenFOAM::OpenFOAM.
include(FoamLnInclude)

if(DEFINED ENV{WM_PROJECT_DIR} AND EXISTS $ENV{WM_PROJECT_DIR}/src/OpenFOAM)
  set(default_source $ENV{WM_PROJECT_DIR})
else()
  set(default_source ${CMAKE_SOURCE_DIR}/.cache/openfoam-1912)
endif()
set(SLIDEWAVE_OPENFOAM_SOURCE ${default_source} CACHE PATH "Folder whose src/ has OpenFOAM's headers")

find_path(OpenFOAM_ETC controlDict HINTS $ENV{WM_PROJECT_DIR}/etc /usr/share/openfoam/etc NO_DEFAULT_PATH)
if(OpenFOAM_ETC)
  file(STRINGS ${OpenFOAM_ETC}/bashrc version_line REGEX "^export WM_PROJECT_VERSION=")
  string(REGEX REPLACE ".*=v?([0-9]*).*" "\\1" OpenFOAM_VERSION "${version_line}")
endif()

# What the fluid engine uses, in the order of their dependence.
set(parts finiteVolume meshTools incompressibleTransportModels interfaceProperties
    immiscibleIncompressibleTwoPhaseMixture OpenFOAM Pstream)
set(OpenFOAM_LIBRARIES)
foreach(part ${parts})
  find_library(OpenFOAM_${part} ${part} PATHS $ENV{FOAM_LIBBIN} $ENV{FOAM_LIBBIN}/openmpi-system /usr/lib
               NO_DEFAULT_PATH)
  list(APPEND OpenFOAM_LIBRARIES ${OpenFOAM_${part}})
  list(APPEND required OpenFOAM_${part})
endforeach()
find_path(OpenFOAM_SOURCE_DIR OpenFOAM/db/Time/Time.H PATHS ${SLIDEWAVE_OPENFOAM_SOURCE}/src NO_DEFAULT_PATH)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  OpenFOAM REQUIRED_VARS OpenFOAM_SOURCE_DIR OpenFOAM_ETC ${required} VERSION_VAR OpenFOAM_VERSION
  REASON_FAILURE_MESSAGE
  "headers: run foam_side/fetch_headers.sh .cache/openfoam-1912, libraries: package openfoam")

if(OpenFOAM_FOUND AND NOT OpenFOAM_VERSION STREQUAL "1912" AND NOT SLIDEWAVE_ALLOW_UNTESTED_OPENFOAM)
  message(FATAL_ERROR "OpenFOAM ${OpenFOAM_VERSION} found, but foam_side is tested with 1912 only: it replaces "
    "four members of UPstream, whose private layout changes between versions. "
    "Set SLIDEWAVE_ALLOW_UNTESTED_OPENFOAM=ON to try.")
endif()

if(OpenFOAM_FOUND AND NOT TARGET OpenFOAM::OpenFOAM)
  set(links ${CMAKE_BINARY_DIR}/lnInclude)
  set(folders OpenFOAM OSspecific/POSIX finiteVolume meshTools transportModels/incompressible
      transportModels/interfaceProperties transportModels/twoPhaseMixture
      transportModels/immiscibleIncompressibleTwoPhaseMixture)
  foam_lninclude(${OpenFOAM_SOURCE_DIR} ${links} ${folders})
  list(TRANSFORM folders PREPEND ${links}/)

  add_library(OpenFOAM::OpenFOAM INTERFACE IMPORTED)
  target_include_directories(OpenFOAM::OpenFOAM SYSTEM INTERFACE
    ${folders} ${OpenFOAM_SOURCE_DIR}/transportModels ${OpenFOAM_SOURCE_DIR}/Pstream/mpi)
  # As Debian built it: double precision, 32-bit labels. Run-time selection tables are static
  # initialisers, so libraries that no symbol asks for are linked as well.
  target_compile_definitions(OpenFOAM::OpenFOAM INTERFACE OPENFOAM=1912 WM_DP WM_LABEL_SIZE=32 NoRepository
    OMPI_SKIP_MPICXX)
  target_compile_options(OpenFOAM::OpenFOAM INTERFACE -ftemplate-depth-100)
  target_link_libraries(OpenFOAM::OpenFOAM INTERFACE
    -Wl,--push-state,--no-as-needed ${OpenFOAM_LIBRARIES} -Wl,--pop-state ${CMAKE_DL_LIBS} MPI::MPI_C)
endif()
