"""`python -m planar_cli`."""

from planar_cli.cli import main

if __name__ == "__main__":
    main()
