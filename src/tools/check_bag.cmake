add_executable(check_bag ${CMAKE_CURRENT_LIST_DIR}/check_bag.cpp)
target_link_libraries(check_bag poinsot_audit CLI11::CLI11)  # rosbag_storage comes with catkin_LIBRARIES

install(TARGETS check_bag RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
