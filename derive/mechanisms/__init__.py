"""One file per machine; a file's presence is its registration (it defines ``mechanism(v)``, see `derive.registry`)."""
