from deltacal_gen.app.cli import main

main()
