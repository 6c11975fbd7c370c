// The game has printed what docs/getting-started.md shows. Maven colours the beginnings of some lines.
def lines = new File(basedir, 'build.log').readLines('UTF-8').collect { it.replaceAll(/\u001B\[\d*m/, '') }
def expected = new File(basedir, 'output.txt').readLines('UTF-8')
assert lines.findAll { it =~ /^\d+ s: / } == expected
