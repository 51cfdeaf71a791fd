# FC-1520 to FC-1539: forms of cycles.

FC-1520 = Düzenleyicide böyle bir çevrim yok
    .detail = { $name }
    .help = Listeden birini seçin.

FC-1521 = Değer sınırlarının dışında
    .detail = { $parameter }: { $min } ile { $max } arası
    .help = Sınırlar arasında bir değer verin; sayılar ve numaralar tamdır.

FC-1522 = Seçenekte böyle bir sözcük yok
    .detail = { $parameter }
    .help = Alanın sunduğu sözcüklerden birini seçin.

FC-1523 = Bu ad programda kullanılamaz
    .detail = { $parameter }
    .help = Harfle başlayın; yalnız harf, rakam ve alt çizgi kullanın, en çok 32.

FC-1524 = Çevrim bu konumlarda yinelenemez
    .help = Tek bir şekil verin, alabileceğinden çok nokta vermeyin; bazı çevrimler konum almaz.

FC-1525 = Profil çevrime uymuyor
    .help = Çevrimin gerektirdiği konturları verin: cep için kapalı, köşeler kenarlarından büyük olmasın; noktadan noktaya en çok 25 doğru ile birleşen nokta alır.

FC-1526 = Çevrim bloklar hâlinde çok uzun olur
    .detail = { $limit }
    .help = Daha büyük adımlar kullanın ya da birkaç çevrime bölün.

FC-1527 = Bu kontrolde böyle eşzamanlı bir diş açma çevrimi yok
    .detail = { $name }
    .help = Geri çekme çarpanını 1 yapın, dengeleyicili tutucuyu seçin ya da kontrolün diş açma parametrelerini denetleyin.

FC-1528 = Çevrim bu kontrolün dilinde yazılamıyor
    .detail = { $name }
    .help = Kontrolün izleyemediği değerleri değiştirin: iş milinin açılı durması, M işlevleri, takım numaraları.
