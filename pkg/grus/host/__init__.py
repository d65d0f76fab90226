"""The YADE that Grus runs in: where it is, whether its binary interface is the supported one."""
