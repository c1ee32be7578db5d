"""``python -m deltacal_gen.app.cli`` is the command ``deltacal``."""

from deltacal_gen.app.cli import main

main()
