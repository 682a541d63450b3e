# The part of PCL that tests/bench/peers needs. PCL's own package file would bring VTK and Qt along.
find_path(PCL_REGISTRATION_HEADERS pcl/registration/ndt.h PATH_SUFFIXES pcl-1.13 pcl-1.14 pcl-1.15 pcl)
set(pcl_libraries "")
foreach(part registration filters sample_consensus search octree kdtree common)
    find_library(PCL_${part}_LIBRARY NAMES pcl_${part})
    list(APPEND pcl_libraries "${PCL_${part}_LIBRARY}")
    mark_as_advanced(PCL_${part}_LIBRARY)
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PclRegistration
    REQUIRED_VARS PCL_REGISTRATION_HEADERS PCL_registration_LIBRARY PCL_kdtree_LIBRARY PCL_common_LIBRARY
    REASON_FAILURE_MESSAGE "install libpcl-dev")
if(PclRegistration_FOUND AND NOT TARGET Pcl::Registration)
    add_library(Pcl::Registration INTERFACE IMPORTED)
    set_target_properties(Pcl::Registration PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${PCL_REGISTRATION_HEADERS}"
        INTERFACE_LINK_LIBRARIES "${pcl_libraries}")
endif()
mark_as_advanced(PCL_REGISTRATION_HEADERS)
