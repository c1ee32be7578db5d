"""RoboTennis, three arms with rods as single links, incremental home: tables and kernels."""
