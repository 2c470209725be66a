add_executable(propagate propagate.cpp csv_rows.cpp)
target_link_libraries(propagate PRIVATE poinsot_core CLI11::CLI11)
install(TARGETS propagate RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
