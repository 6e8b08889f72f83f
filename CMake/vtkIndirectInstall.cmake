# What `cmake --install` leaves behind besides the modules themselves.
