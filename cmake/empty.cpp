// a module without sources yet
